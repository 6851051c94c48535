// Of the programs' room only how a project is read: the worker holds no simulation.
import { parseProject, ProjectError, writeProject } from '@botgarten/programs/project'
import { hashOf } from '../hashes.ts'
import type { Turn } from '../fair-queue.ts'

export interface Asset {
  /** By which the project names it. */
  readonly name: string
  /** Of its content, made here: a name may lie, and must not show another child's picture. */
  readonly hash: string
  readonly type: string
  readonly base64: string
}

/** A project that the lab's own parser has let through, taken apart for the database. */
export interface Checked {
  readonly name: string
  readonly card: string | null
  /** From how many start places of the card every check has passed. */
  readonly done: number
  /** The project as JSON, its assets left out. */
  readonly document: string
  /** Hash of all of it: two saves of the same work are the same version. */
  readonly hash: string
  readonly assets: readonly Asset[]
}

/**
 * Checks the text of a project.
 * @param turn the pupil who sends it; none: a teacher does
 * @returns the reason where it is refused: `tooBig`, `notAProject`, `tooLong` (in time) …
 */
export type CheckProject = (text: string, turn?: Turn) => Promise<Checked | { readonly refused: string }>

/** What the worker does. Nothing of the project is run. */
export function checkProject(text: string): Checked | { readonly refused: string } {
  try {
    const { assets, ...project } = parseProject(text)
    const document = writeProject({ ...project, assets: {} })
    const list = Object.entries(assets).map(([name, asset]) => ({
      ...{ name, hash: hashOf(`${asset.type} ${asset.base64}`) },
      ...asset,
    }))
    const hash = hashOf(JSON.stringify([document, list.map(({ name, hash }) => [name, hash]).toSorted()]))
    const done = new Set(project.progress?.starts).size
    return { name: project.name, card: project.card ?? null, done, document, hash, assets: list }
  } catch (error) {
    if (error instanceof ProjectError) return { refused: error.reason }
    throw error
  }
}
