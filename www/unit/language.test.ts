import { afterAll, afterEach, beforeEach, describe, expect, it, vi } from 'vitest'
import { termsIn } from '../src/features/glossary/terms'
import { closest, language } from '../src/locales/language.svelte'
import { common } from '../src/locales/en/common'
import { keys } from '../src/locales/en/keys'
import { punctuation } from '../src/locales/en/punctuation'
import { texts, translateBy } from '../src/locales/texts'
import { firstLanguage, nextLanguage, withoutLanguage } from '../src/stores/language'
import { sceneText } from '../src/text/scene-text'

const HAN = /[\u3400-\u9fff]/

/** What a browser has of languages. */
const stored = new Map<string, string>()
vi.stubGlobal('localStorage', {
  getItem: (key: string) => stored.get(key) ?? null,
  setItem: (key: string, value: string) => stored.set(key, value),
})

afterEach(async () => {
  await language.speak('en')
  stored.clear()
})

afterAll(() => {
  Reflect.deleteProperty(globalThis, 'localStorage')
})

describe('texts', () => {
  it('are those of another language where it has them, and English where it has none', () => {
    const words = texts('words', { title: 'Title', of: { one: 'One', two: (n: number) => `Two ${n}`, three: 'Three' }, list: ['a', 'b'] })
    translateBy((module) => (module === 'words' ? { of: { one: 'Eins', two: (n: number) => `Zwei ${n}` }, list: ['c'] } : undefined))
    expect([words.title, words.of.one, words.of.two(2), words.of.three, ...words.list]).toEqual(['Title', 'Eins', 'Zwei 2', 'Three', 'c'])
    expect(Object.keys(words.of)).toEqual(['one', 'two', 'three'])
    expect({ ...words }.of.one).toBe('Eins')
    translateBy(() => undefined)
    expect(words.of.one).toBe('One')
  })
})

describe('the language of the page', () => {
  beforeEach(() => translateBy((module) => Reflect.get(language, 'texts')[module]))

  it('is the closest one to what a browser or a link asks for', () => {
    expect(['zh', 'zh-CN', 'ZH-hans-SG', 'en-GB', 'fr', ''].map(closest)).toEqual(['zh-CN', 'zh-CN', 'zh-CN', 'en', undefined, undefined])
  })

  it('changes all texts, and tells who wants to know', async () => {
    const told = vi.fn()
    language.listeners.add(told)
    const before = common.bar.undo
    await language.speak('zh-CN')
    expect(common.bar.undo).toMatch(HAN)
    expect(keys.groups.every(({ title }) => HAN.test(title))).toBe(true)
    expect(punctuation.clauses(['粒子', '', '蚂蚁'])).toBe('粒子，蚂蚁')
    expect(nextLanguage().tag).toBe('en')
    await language.speak('en')
    expect(common.bar.undo).toBe(before)
    expect(told).toHaveBeenCalledTimes(2)
    language.listeners.delete(told)
  })

  it('has the words of the first view first, and all of them when it is completed', async () => {
    await language.speak('zh-CN', true)
    expect(common.bar.undo).toMatch(HAN)
    expect(keys.title).toBe('Keys')
    await language.complete()
    expect(keys.title).toMatch(HAN)
  })

  it('is that of the link, else of the query, else the one that was chosen, else the browser’s', () => {
    vi.stubGlobal('navigator', { languages: ['fr', 'zh-TW', 'en'] })
    expect(firstLanguage('', '')).toBe('zh-CN')
    stored.set('forage.language', 'en')
    expect(firstLanguage('', '')).toBe('en')
    expect(firstLanguage('', '?embed&lang=zh')).toBe('zh-CN')
    expect(firstLanguage('#v=1&planner=pso&page.lang=en', '?lang=zh')).toBe('en')
    expect(firstLanguage('#view=learn&page.lang=xx', '')).toBe('en')
    Reflect.deleteProperty(globalThis, 'navigator')
  })

  it('is no part of what a link is of', () => {
    expect(withoutLanguage('#v=1&planner=pso&page.lang=zh-CN&seed=3')).toBe('#v=1&planner=pso&seed=3')
    expect(withoutLanguage('#page.lang=zh-CN')).toBe('#')
    expect(withoutLanguage('#view=learn')).toBe('#view=learn')
  })

  it('names random scenes by what they are of, and leaves titles that somebody wrote', async () => {
    await language.speak('zh-CN')
    language.titles = new Map([['Maze', '迷宫']])
    expect(sceneText('Maze, 41 × 31, seed 7')).toBe('迷宫（41 × 31，随机种子 7）')
    expect(sceneText('My room, seed 7')).toBe('My room, seed 7')
  })
})

describe('terms of the glossary', () => {
  const pieces = (text: string, tag: string, before = new Set<string>()) => termsIn(text, tag, before).filter(({ term }) => term)

  it('are found once in a text, whole, by their names and letters', () => {
    expect(pieces('Inertia weights: the inertia weight of PSO, not weightings.', 'en')).toEqual([
      { text: 'Inertia weights', term: 'inertia weight' },
      { text: 'PSO', term: 'particle swarm optimization (PSO)' },
    ])
    expect(pieces('惯性权重决定粒子保留多少速度，惯性权重越大越好。', 'zh-CN')).toEqual([{ text: '惯性权重', term: 'inertia weight' }])
  })

  it('are left out where they were named before, and nothing of the text is lost', () => {
    const text = 'A particle has a personal best and a global best.'
    const before = new Set(['personal best'])
    expect(pieces(text, 'en', before).map(({ term }) => term)).not.toContain('personal best')
    expect(before).toContain('global best')
    expect(
      termsIn(text, 'en', new Set())
        .map((piece) => piece.text)
        .join(''),
    ).toBe(text)
  })
})
