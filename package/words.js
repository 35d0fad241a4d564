/**
 * Says messages: what the module, which has no words, is given by `speakBy`. Patterns are Fluent's, a file a language.
 *
 *     import { speakBy } from 'forage-lab'
 *     import { speaker } from 'forage-lab/words'
 *     speakBy(speaker('zh', await (await fetch('…/locales/zh.json')).json()))
 */
import { FluentBundle, FluentNumber, FluentResource } from '@fluent/bundle'

/** A number as it is, with all its digits; plurals are chosen by it as by any number. */
class Plain extends FluentNumber {
  toString() {
    return plain(this.value)
  }
}

/** A number with so many digits after the point. */
class Fixed extends FluentNumber {
  toString() {
    return fixed(this.value, this.opts.digits)
  }
}

/** All digits and no exponent, as Rust writes numbers. */
function plain(value) {
  const text = String(value)
  const found = /^(-?)(\d)(?:\.(\d+))?e([+-]\d+)$/.exec(text)
  if (!found) return { NaN: 'NaN', Infinity: 'inf', '-Infinity': '-inf' }[text] ?? (Object.is(value, -0) ? '-0' : text)
  const [, sign, first, rest = '', exponent] = found
  const digits = first + rest
  const point = 1 + Number(exponent)
  if (point <= 0) return `${sign}0.${'0'.repeat(-point)}${digits}`
  return sign + digits.padEnd(point, '0')
}

/** Rounded to the nearest, and half to even, as Rust does; `toFixed` rounds halves away from zero. */
function fixed(value, digits) {
  if (!Number.isFinite(value) || Math.abs(value) >= 1e21) return plain(value)
  const rounded = value.toFixed(digits)
  const exact = value.toFixed(Math.min(100, digits + 60))
  const tail = exact.slice(exact.indexOf('.') + 1 + digits)
  const shown =
    /^50*$/.test(tail) && Number(rounded.at(-1)) % 2 === 1 ? exact.slice(0, exact.indexOf('.') + (digits && 1 + digits)) : rounded
  return Object.is(value, -0) || (value < 0 && !shown.startsWith('-')) ? `-${shown.replace('-', '')}` : shown
}

const functions = { NUMBER: ([value], { digits }) => new Fixed(value.valueOf(), { digits: Number(digits.valueOf()) }) }

/** Between Han there is no space: where one is left by what was put in, it goes. */
const HAN = '[\\u3000-\\u303f\\u3400-\\u9fff\\uff00-\\uffef]'
const NEEDLESS = new RegExp(`(?<=${HAN}) (?=${HAN})`, 'g')
const joined = (said) => said.replace(NEEDLESS, '')

/** A function of a key and its arguments that says a message: undefined where there are no words for it. `add` gives it more. */
export function speaker(locale, patterns) {
  const bundle = new FluentBundle(locale, { functions, useIsolating: false })
  const say = (key, given) => {
    const pattern = bundle.getMessage(key)?.value
    if (pattern == null) return undefined
    const named = Object.entries(given).map(([name, value]) => [name, typeof value === 'number' ? new Plain(value) : value])
    return joined(bundle.formatPattern(pattern, Object.fromEntries(named), []))
  }
  say.add = (more) => {
    const text = Object.entries(more).map(([key, pattern]) => `${key} = ${pattern.replaceAll('\n', '\n    ')}\n`)
    bundle.addResource(new FluentResource(text.join('')), { allowOverrides: true })
  }
  say.add(patterns)
  return say
}
