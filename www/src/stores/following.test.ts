import { beforeEach, expect, test } from 'vitest'
import { Following } from './following.svelte'

type Values = Record<string, unknown>

let asked: { params: Values; answer(): Promise<void> }[]
let following: Following<Values, { end: number; result: Values }>

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
              : { ok: true, value: { result: params, generation: 1, iteration: 1 } },
          )
          await new Promise((passed) => setTimeout(passed))
        }
        asked.push({ params, answer })
      }),
    (result) => ({ end: 1, result }),
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
  expect(following.track?.result).toEqual({ speed: 2, margin: 3 })
})

test('a value that is refused takes no other with it', async () => {
  void following.setParameter('speed', 2)
  void following.setParameter('margin', 'wrong')
  await answerAll()
  expect(following.params).toEqual({ speed: 2 })
  expect(following.errors).toEqual({ margin: 'refused' })
})

test('a value that is refused takes no later one with it', async () => {
  void following.setParameter('margin', 'wrong')
  void following.setParameter('speed', 2)
  await answerAll()
  expect(following.params).toEqual({ speed: 2 })
  expect(following.errors).toEqual({ margin: 'refused' })
  expect(following.problem).toBe('')
})

test('of several values that are refused each has its message', async () => {
  void following.setParameter('margin', 'wrong')
  void following.setParameter('speed', 'wrong')
  void following.setParameter('period', 2)
  await answerAll()
  expect(following.params).toEqual({ period: 2 })
  expect(following.errors).toEqual({ margin: 'refused', speed: 'refused' })
})

test('a value that was not answered when the picture went back to the run is not asked for again', async () => {
  void following.setParameter('margin', 'wrong')
  following.leave()
  await answerAll()
  void following.begin()
  await answerAll()
  expect(following.track?.result).toEqual({})
  expect(following.errors).toEqual({})
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
