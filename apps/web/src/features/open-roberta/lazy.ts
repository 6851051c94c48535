// What writes Open Roberta's files: only one who asks for such a file waits for it.
import { strToU8, zipSync } from 'fflate'
import { handOut } from '#storage/handout.ts'
import { m } from '#words/message.ts'
import type { Project } from '@botgarten/programs'
import { filesOf, outgoingOf, type Outgoing, save } from './outgoing.ts'

export { differencesOf } from '@botgarten/programs/open-roberta'
export { default as SaveDialog } from './SaveDialog.svelte'

/**
 * Hands a robot's program out as a file for Open Roberta; the first robot's where none is named. Where Open Roberta does
 * not know all of it, nothing is handed out, and the child is to be asked first.
 */
export function saveOpenRobertaFile(project: Project, robot = ''): Outgoing | null {
  const outgoing = outgoingOf(project, robot)
  if (outgoing.kin.length > 0) return outgoing
  save(outgoing)
  return null
}

/** Hands every program of these projects out, in one archive. */
export function saveAllPrograms(projects: readonly Project[]): void {
  const files = Object.entries(filesOf(projects, m['openRoberta.folder']()))
  const archive = zipSync(Object.fromEntries(files.map(([path, text]) => [path, strToU8(text)])))
  handOut(m['openRoberta.archive'](), archive, 'zip')
}
