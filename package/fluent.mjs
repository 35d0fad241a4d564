// English as it stands beside the code, with the placeholders of Rust's `format!`, as a pattern of Fluent.

/** The pattern of a message, as `forage list --messages` has it. */
export function pattern({ key, english, plurals = [] }) {
  const words = new Map(plurals.map(([name, one, other]) => [name, { one, other }]))
  const escaped = english.replace(/\{\{|\}\}|\{([a-z_][a-z0-9_]*)(?::\.(\d+))?\}|[{}]/g, (found, name, digits) => {
    if (found === '{{' || found === '}}') return `{ "${found[0]}" }`
    if (name === undefined) throw new Error(`${key}: a placeholder that Fluent has no word for in "${english}"`)
    const plural = words.get(name)
    if (plural) return `{ $${name} ->\n    [one] ${plural.one}\n   *[other] ${plural.other}\n}`
    return digits === undefined ? `{ $${name} }` : `{ NUMBER($${name}, digits: ${digits}) }`
  })
  return escaped === '' ? '{ "" }' : escaped.replace(/^[ .*[]|[ ]$/g, (at) => `{ "${at}" }`)
}
