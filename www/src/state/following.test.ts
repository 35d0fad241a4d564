import { beforeEach, expect, test } from 'vitest'
import { Following } from './following.svelte'

type Values = Record<string, unknown>

let asked: { params: Values; answer(): Promise<void> }[]
let following: Following<Values, { end: number; told: Values }>

beforeEach(() => {
  asked = []
  following = new Following(
    1,
    (params) =>
      new Promise((resolve) => {
        const refused = Object.keys(params).find((name) => params[name] === 'wrong')
        const answer = async (): Promise<void> => {
          resolve(
            refused
              ? { ok: false, refusal: { field: refused, message: 'refused' } }
              : { ok: true, value: { told: params, generation: 1, iteration: 1 } },
          )
          await new Promise((passed) => setTimeout(passed))
        }
        asked.push({ params, answer })
      }),
    (told) => ({ end: 1, told }),
  )
})

async function answerAll(): Promise<void> {
  for (let next = asked.shift(); next; next = asked.shift()) await next.answer()
}

test('parameters that are set faster than they are answered all hold', async () => {
  void following.setParameter('speed', 2)
  void following.setParameter('margin', 3)
  await answerAll()
  expect(following.params).toEqual({ speed: 2, margin: 3 })
  expect(following.track?.told).toEqual({ speed: 2, margin: 3 })
})

test('a value that is refused takes no other with it', async () => {
  void following.setParameter('speed', 2)
  void following.setParameter('margin', 'wrong')
  await answerAll()
  expect(following.params).toEqual({ speed: 2 })
  expect(following.errors).toEqual({ margin: 'refused' })
})

test('a reset that is asked for before the answer holds', async () => {
  void following.setParameter('speed', 2)
  void following.resetParameter('speed')
  await answerAll()
  expect(following.params).toEqual({})
})

test('an answer that comes after leaving shows nothing', async () => {
  void following.begin()
  following.leave()
  await answerAll()
  expect(following.track).toBeNull()
})
