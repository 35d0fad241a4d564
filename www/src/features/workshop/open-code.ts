import { scenes } from '../../locales/en/scenes'
import type { Lab } from '../../stores/lab.svelte'

/** Offers the code of a file: it is seen before it runs. */
export async function openCode(lab: Lab, file: File): Promise<void> {
  try {
    lab.own.bring({ code: await file.text(), link: null, file: file.name })
  } catch {
    lab.notices.text = scenes.imported.unreadable(file.name)
  }
}
