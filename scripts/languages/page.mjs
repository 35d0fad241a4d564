// The texts of the page: modules of TypeScript, whose exported objects have texts and functions that return one. A text is known by
// the names that lead to it, `arm.sections.motion`; what stands between, such as a helper, by its own name, `batch.list`.
import { readdirSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'

const ts = createRequire(new URL('../../www/package.json', import.meta.url))('typescript')

/** What holds more texts, without the parts that only say types. */
function bare(node) {
  return ts.isAsExpression(node) || ts.isSatisfiesExpression(node) || ts.isParenthesizedExpression(node) ? bare(node.expression) : node
}

const spelled = (node, file) => node.getText(file).replace(/\s*\n\s*/g, ' ')

function leaves(node, path, file, found) {
  const value = bare(node)
  if (!ts.isObjectLiteralExpression(value)) return found.set(path, spelled(value, file))
  for (const property of value.properties) {
    if (ts.isPropertyAssignment(property)) leaves(property.initializer, `${path}.${property.name.text}`, file, found)
    else found.set(`${path}.${spelled(property, file)}`, spelled(property, file))
  }
}

/** The texts of a module, as they are written, by the names that lead to them: those that it exports, and what it makes them with. */
export function textsOf(name, source) {
  const file = ts.createSourceFile(`${name}.ts`, source, ts.ScriptTarget.Latest, true)
  const [exported, helpers] = [new Map(), new Map()]
  for (const statement of file.statements) {
    if (!ts.isVariableStatement(statement)) continue
    const found = statement.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword) ? exported : helpers
    for (const {
      name: { text },
      initializer,
    } of statement.declarationList.declarations) {
      const call = bare(initializer)
      // `texts('arm', { … })`: what the call is given.
      const given = ts.isCallExpression(call) && call.expression.getText(file) === 'texts' ? call.arguments.at(-1) : call
      leaves(given, text === name ? name : `${name}.${text}`, file, found)
    }
  }
  return { exported: Object.fromEntries(exported), helpers: Object.fromEntries(helpers) }
}

/** The texts of a folder's modules. */
export function textsIn(folder) {
  const files = readdirSync(folder)
    .filter((file) => file.endsWith('.ts'))
    .sort()
  const all = files.map((file) => textsOf(file.slice(0, -3), readFileSync(`${folder}/${file}`, 'utf8')))
  const merged = (kind) => Object.assign({}, ...all.map((texts) => texts[kind]))
  return { exported: merged('exported'), helpers: merged('helpers') }
}

/** A module to be translated: that of English with other types. `from`: where the English is, as the new module imports it. */
export function skeletonOf(source, from) {
  const exported = []
  const body = source
    .replace(/^import .*\n/gm, '')
    .replace(/^export const (\w+)(?:: [^=]+)? = (texts\('\w+', )?/gm, (_, name) => {
      exported.push(name)
      return `export const ${name}: Translated<typeof English.${name}> = `
    })
    .replace(/^\}( as const)?\)?$/gm, '}')
  const types = [...source.matchAll(/^export (?:interface|type) (\w+)/gm)].map(([, name]) => name)
  const own = body.replace(/^export interface \w+ \{\n[\s\S]*?^\}\n+/gm, '').replace(/^(?:\/\*\*.*\*\/\n)?export type .*\n+/gm, '')
  const used = types.filter((name) => new RegExp(`\\b${name}\\b`).test(own))
  const imports = [
    `import type * as English from '${from}'`,
    ...(used.length > 0 ? [`import type { ${used.join(', ')} } from '${from}'`] : []),
    `import type { Translated } from '${from.replace(/en\/\w+$/, 'texts')}'`,
  ]
  return `${imports.join('\n')}\n\n${own.trimStart()}`
}
