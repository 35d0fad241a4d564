import type { Reachability, Scene } from 'forage-lab'
import { other } from './threads'
import type { Answer } from '../protocol'

/** Has another thread find out where a tip can come: of several questions only the last is answered. */
export class Surveyor {
  private present: { end(): void } | undefined

  async ask(scene: Scene, step: number): Promise<Answer<Reachability> | null> {
    this.callOff()
    const { api, failed, end } = other()
    const called = new Promise<null>((resolve) => {
      this.present = {
        end: () => {
          end()
          resolve(null)
        },
      }
    })
    try {
      return await Promise.race([api.survey(scene, step), failed, called])
    } finally {
      end()
    }
  }

  callOff(): void {
    this.present?.end()
    this.present = undefined
  }
}
