import { describe, expect, test, vi } from 'vitest'
import { CODE, called, client, eachByItself, made, named, report, running, start, thread, threads } from '../../unit/client'
import type { ToHost } from './protocol'
import { Gone } from './run-client'
import { UNSTOPPABLE } from './watchdog'

eachByItself()

describe('a thread that does not receive', () => {
  test('is replaced after three seconds, by one that goes on', async () => {
    await running(start(1, 3))
    client.want({ target: { at: 40, play: true } })
    const question = client.api.newSeed()
    await vi.advanceTimersByTimeAsync(2900)
    expect(threads).toHaveLength(1)
    await vi.advanceTimersByTimeAsync(200)
    expect([threads.length, threads[0]?.ended, called('onreplaced')]).toEqual([2, true, [[false]]])
    expect(thread().wants()).toEqual([{ ...client.desired }])
    expect(client.desired).toMatchObject({ start: start(1, 40, true), target: null })
    const { number } = thread().last('ask') as ToHost
    thread().say({ is: 'answer', number, value: 5 })
    expect(await question).toBe(5)
  })

  test('is not replaced when it has received all', async () => {
    await running()
    client.want({ speed: 1 })
    await vi.advanceTimersByTimeAsync(2000)
    thread().see()
    await vi.advanceTimersByTimeAsync(20_000)
    expect(threads).toHaveLength(1)
  })

  test('a receipt of something earlier is none of what came later', async () => {
    await running()
    client.want({ speed: 1 })
    const first = thread().sent.at(-1)?.number ?? 0
    client.want({ speed: 2 })
    thread().say({ is: 'seen', number: first })
    thread().say({ is: 'seen', number: first - 1 })
    await vi.advanceTimersByTimeAsync(3100)
    expect(threads).toHaveLength(2)
  })

  test('that receives only a part is replaced; one that receives the rest is not', async () => {
    for (const [rest, after] of [
      [false, 2],
      [true, 1],
    ] as const) {
      threads.length = 0
      await running()
      client.want({ speed: 1 })
      const first = thread().sent.at(-1)?.number ?? 0
      client.want({ speed: 2 })
      client.want({ speed: 3 })
      thread().say({ is: 'seen', number: first })
      // Now the last of them is awaited.
      await vi.advanceTimersByTimeAsync(0)
      thread().say({ is: 'seen', number: first + 1 })
      await vi.advanceTimersByTimeAsync(0)
      if (rest) thread().see()
      await vi.advanceTimersByTimeAsync(10_000 * Number(rest) + 3100)
      expect(threads).toHaveLength(after)
      client.close()
    }
  })

  test('a client that is closed replaces none', async () => {
    await running()
    client.want({ speed: 1 })
    client.close()
    await vi.advanceTimersByTimeAsync(10_000)
    expect([threads.length, thread().ended]).toEqual([1, true])
    const sent = thread().sent.length
    client.giveBack(new ArrayBuffer(1))
    client.want({ speed: 2 })
    expect(thread().sent).toHaveLength(sent)
  })

  test('without any run nothing is begun again', async () => {
    made()
    await client.open()
    await vi.advanceTimersByTimeAsync(3100)
    expect([threads.length, thread().wants()[0]?.start]).toEqual([2, null])
  })
})

describe('somebody’s code', () => {
  const pings = (): number => thread().sent.filter(({ is }) => is === 'ping').length

  test('is asked for signs of life while it is there', async () => {
    await running()
    await vi.advanceTimersByTimeAsync(2000)
    expect(pings()).toBe(0)
    const begin = client.want({ start: start(2, 0, false, CODE) })
    await vi.advanceTimersByTimeAsync(1100)
    thread().see()
    expect(pings()).toBe(2)
    thread().say(report(begin, 0, { fresh: begin }))
    await vi.advanceTimersByTimeAsync(1000)
    thread().see()
    expect(pings()).toBe(4)
    const other = client.want({ start: start(3) })
    thread().say(report(other, 0, { fresh: other }))
    thread().see()
    await vi.advanceTimersByTimeAsync(5000)
    expect(pings()).toBe(4)
  })

  test('is left alone while its states are asked for, and while nothing but its text is read it is asked', async () => {
    await running(start(1, 0, false, CODE))
    const states = client.api.states()
    await vi.advanceTimersByTimeAsync(600)
    thread().see()
    expect(pings()).toBe(0)
    thread().say({ is: 'answer', number: thread().last('ask')?.number ?? 0, value: [] })
    await states
    await vi.advanceTimersByTimeAsync(600)
    expect(pings()).toBe(1)
  })

  test('is asked for signs of life while it is read, whatever runs', async () => {
    await running()
    void client.api.read('register({})')
    await vi.advanceTimersByTimeAsync(600)
    expect(pings()).toBe(1)
    thread().see()
    thread().say({ is: 'answer', number: thread().last('ask')?.number ?? 0, value: null })
    await vi.advanceTimersByTimeAsync(2000)
    expect(pings()).toBe(1)
  })

  test('that is refused is no longer asked for', async () => {
    await running()
    const begin = client.want({ start: start(2, 0, false, CODE) })
    thread().see()
    thread().say({ is: 'refused', version: begin, refusal: { message: 'no', field: 'code' } })
    await vi.advanceTimersByTimeAsync(2000)
    expect(pings()).toBe(0)
  })

  test('without an interpreter goes on with one when it does not end', async () => {
    await running(start(1, 4, true, { ...CODE, full: true }))
    thread().say(report(client.version, 6, { playing: true, arrived: false }))
    client.want({ speed: 1 })
    await vi.advanceTimersByTimeAsync(3100)
    expect([called('onreplaced'), client.desired.start]).toEqual([[[true]], start(1, 6, true, { ...CODE, full: false })])
  })

  test('whose start does not end is refused when the run of before is there again', async () => {
    await running(start(1, 4))
    const begin = client.want({ start: start(2, 0, true, CODE) })
    await vi.advanceTimersByTimeAsync(3100)
    expect([threads.length, called('onreplaced'), called('onrefused')]).toEqual([2, [[false]], []])
    expect(client.desired.start).toEqual(start(1, 4, false))
    thread().say(report(client.version, 4, { fresh: client.version }))
    expect(called('onrefused')).toEqual([[{ message: UNSTOPPABLE, field: 'code' }, begin]])
    // Once.
    thread().say(report(client.version, 4, { fresh: client.version }))
    expect(called('onrefused')).toHaveLength(1)
  })

  test('whose start does not end is refused whatever else is wanted meanwhile', async () => {
    await running(start(1, 4))
    const begin = client.want({ start: start(2, 0, true, CODE) })
    await vi.advanceTimersByTimeAsync(3100)
    client.want({ speed: 2 })
    // A report of the thread that begins is none of a run.
    thread().say(report(client.version, 0))
    expect(called('onrefused')).toEqual([])
    thread().say(report(client.version, 4, { fresh: client.version }))
    expect(called('onrefused')).toEqual([[{ message: UNSTOPPABLE, field: 'code' }, begin]])
  })

  test('without an interpreter that does not end while it is read is refused, and its run goes on with one', async () => {
    await running(start(1, 4, false, { ...CODE, full: true }))
    const read = client.api.read('for (;;);')
    await vi.advanceTimersByTimeAsync(3600)
    expect(await read).toMatchObject({ ok: false })
    expect(called('onreplaced')).toEqual([[false]])
  })

  test('without an interpreter whose states do not come may be why', async () => {
    await running(start(1, 4, false, { ...CODE, full: true }))
    const failed = expect(client.api.states()).rejects.toBeInstanceOf(Gone)
    await vi.advanceTimersByTimeAsync(3600)
    await failed
    expect(called('onreplaced')).toEqual([[true]])
  })

  test('whose start does not end is not refused when another start is wanted', async () => {
    await running(start(1, 4))
    client.want({ start: start(2, 0, true, CODE) })
    await vi.advanceTimersByTimeAsync(3100)
    const begin = client.want({ start: start(3) })
    thread().say(report(begin, 0, { fresh: begin }))
    expect(called('onrefused')).toEqual([])
  })

  test('whose step does not end stays where it was before', async () => {
    await running(start(1, 4, true, CODE), { onstuck: named('onstuck') })
    thread().say(report(client.version, 6, { playing: true, arrived: false }))
    await vi.advanceTimersByTimeAsync(3600)
    expect([threads.length, called('onstuck'), called('onreplaced')]).toEqual([2, [[]], [[false]]])
    expect(client.desired.start).toEqual(start(1, 6, false, CODE))
  })

  test('whose step does not end is a breakdown where nobody shows that', async () => {
    await running(start(1, 4, true, CODE))
    await vi.advanceTimersByTimeAsync(3600)
    expect([threads.length, thread().ended, called('onbroken'), called('onreplaced')]).toEqual([1, true, [[UNSTOPPABLE]], []])
  })

  test('whose very first start does not end is a breakdown', async () => {
    made({ onstuck: named('onstuck') })
    await client.open()
    thread().see()
    client.want({ start: start(1, 0, true, CODE) })
    await vi.advanceTimersByTimeAsync(3600)
    expect([threads.length, called('onbroken'), called('onstuck')]).toEqual([1, [[UNSTOPPABLE]], []])
  })

  test('whose states do not come is asked for them no more; what else was asked is', async () => {
    await running(start(1, 4, false, CODE), { onstuck: named('onstuck') })
    const states = client.api.states()
    const failed = expect(states).rejects.toBeInstanceOf(Gone)
    void client.api.newSeed()
    await vi.advanceTimersByTimeAsync(3600)
    await failed
    expect([threads.length, called('onreplaced'), called('onstuck')]).toEqual([2, [[false]], []])
    expect(thread().sent.filter(({ is }) => is === 'ask')).toMatchObject([{ question: { name: 'newSeed' } }])
  })

  test('that does not end while it is read is refused', async () => {
    await running()
    const read = client.api.read('for (;;);')
    await vi.advanceTimersByTimeAsync(3600)
    expect(await read).toEqual({ ok: false, refusal: { message: UNSTOPPABLE, field: 'code' } })
    expect([threads.length, called('onreplaced')]).toEqual([2, [[false]]])
  })

  test('that runs may be why another one is not read: that is asked again', async () => {
    await running(start(1, 4, true, CODE), { onstuck: named('onstuck') })
    thread().say(report(client.version, 6, { playing: true, arrived: false }))
    void client.api.read('register({})')
    await vi.advanceTimersByTimeAsync(3600)
    expect(called('onstuck')).toEqual([[]])
    expect(thread().last('ask')).toMatchObject({ question: { name: 'read' } })
  })

  test('that stands still is not why another one is not read', async () => {
    await running(start(1, 4, false, CODE), { onstuck: named('onstuck') })
    const read = client.api.read('for (;;);')
    await vi.advanceTimersByTimeAsync(3600)
    expect(await read).toMatchObject({ ok: false })
    expect(called('onstuck')).toEqual([])
  })

  test('that is on its way somewhere may be why another one is not read', async () => {
    await running(start(1, 4, false, CODE), { onstuck: named('onstuck') })
    client.want({ target: { at: 9, play: false } })
    void client.api.read('for (;;);')
    await vi.advanceTimersByTimeAsync(3600)
    expect(called('onstuck')).toEqual([[]])
  })
})
