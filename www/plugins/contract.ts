import { readFile } from 'node:fs/promises'
import ts from 'typescript'
import type { Plugin } from 'vite'

const ID = 'virtual:contract'
const RESOLVED = `\0${ID}`

/** What an author can write in one place, or call. */
export interface Member {
  name: string
  /** Its type, as the contract has it. */
  type: string
  help: string
  call: boolean
  optional: boolean
}

const squeezed = (text: string): string => text.replace(/\s+/g, ' ').trim()

/** The members of the interfaces of a declaration file, by the interfaces' names. */
export function contractOf(text: string): Record<string, Member[]> {
  const source = ts.createSourceFile('planner.d.ts', text, ts.ScriptTarget.Latest, true)
  const found: Record<string, Member[]> = {}
  for (const statement of source.statements) {
    if (!ts.isInterfaceDeclaration(statement)) continue
    found[statement.name.text] = statement.members.flatMap((member): Member[] => {
      if (!(ts.isPropertySignature(member) || ts.isMethodSignature(member)) || !member.name) return []
      const name = member.name.getText(source)
      const docs = ts.getJSDocCommentsAndTags(member).map((doc) => (typeof doc.comment === 'string' ? doc.comment : ''))
      const call = ts.isMethodSignature(member)
      const type = call
        ? `${name}(${member.parameters.map((parameter) => parameter.getText(source)).join(', ')}): ${member.type?.getText(source) ?? 'void'}`
        : `${name}: ${member.type?.getText(source) ?? 'unknown'}`
      return [{ name, type: squeezed(type), help: squeezed(docs.join(' ')), call, optional: member.questionToken !== undefined }]
    })
  }
  return found
}

/** `virtual:contract`: the interfaces of the package's `planner.d.ts`, for help while somebody writes a planner. */
export const contract = (file: string): Plugin => ({
  name: 'forage-contract',
  resolveId: (id) => (id === ID ? RESOLVED : undefined),
  async load(id) {
    if (id !== RESOLVED) return undefined
    this.addWatchFile(file)
    return `export const contract = ${JSON.stringify(contractOf(await readFile(file, 'utf8')))}`
  },
})
