import type { NamedFile } from 'forage-lab'
import { punctuation } from '../../locales/en/punctuation'
import { scenes } from '../../locales/en/scenes'
import type { Lab } from '../../stores/lab.svelte'
import type { ImportedFiles } from '../../stores/scene.svelte'

async function read(file: File): Promise<NamedFile> {
  return { name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) }
}

async function take(lab: Lab, files: NamedFile[], problem?: number): Promise<void> {
  const answer = await lab.scene.ask(async () => lab.api.importScene(files, problem))
  if (!answer) return
  if (!answer.ok) {
    const { refusal } = answer
    const { message } = refusal
    const names = files.map(({ name }) => name)
    // What is wrong within a scene is told by its fields.
    const named = refusal.unloaded || names.some((name) => message.includes(name))
    lab.notices.warn(refusal, scenes.imported.files(named ? message : punctuation.pair(punctuation.list(names), message)), () =>
      take(lab, files, problem),
    )
    return
  }
  const { scene, notes, problems } = answer.value
  lab.setup.openScene(scene)
  if (notes.length > 0 || problems.length > 1) lab.scene.imported = { files, notes, problems, problem: problem ?? problems.length - 1 }
}

/** Scenes and maps, each of one file or of two that belong together; the code of a planner, where such code can be edited. */
export async function importFiles(lab: Lab, files: Iterable<File>, code = false): Promise<void> {
  const given = [...files]
  const [first] = given
  if (code && first && /\.m?js$/i.test(first.name)) {
    await (await import('../workshop/open-code')).openCode(lab, first)
    return
  }
  let named: NamedFile[] | null
  try {
    named = await lab.scene.ask(() => Promise.all(given.map(read)))
  } catch {
    // A folder, or a file that has gone meanwhile.
    lab.notices.text = scenes.imported.unreadable(punctuation.list(given.map(({ name }) => name)))
    return
  }
  if (named) await take(lab, named)
}

/** The ends of another of the problems, in the map as the file has it. */
export async function chooseProblem(lab: Lab, { files }: ImportedFiles, problem: number): Promise<void> {
  await take(lab, files, problem)
}
