import type { Facts } from '@botgarten/blocks'
import { parseProject, ProjectError, writeProject, type Project } from '@botgarten/programs'
import { freshId, save } from './projects.ts'

/** Why a file was not taken up, as the words `problem.<problem>.title` and `.text` with their facts. */
export interface Refusal {
  readonly problem: string
  readonly facts: Facts
}

/** A file that was opened is a new project of this device. */
export type OpenedFile = { readonly id: string; readonly project: Project } | Refusal

const MOST_BYTES = 5_000_000

/** Takes a project file up; what was open before stays as it is. */
export async function openProjectFile(file: File): Promise<OpenedFile> {
  if (file.size > MOST_BYTES) return { problem: 'tooBig', facts: {} }
  try {
    const project = parseProject(await file.text())
    const id = freshId(project.card ?? 'free')
    const { kind } = await save(id, project, 0)
    return kind === 'saved' ? { id, project } : { problem: 'notKept', facts: {} }
  } catch (error) {
    if (!(error instanceof ProjectError)) throw error
    console.warn('The project file was refused.', error)
    return { problem: error.reason, facts: error.facts }
  }
}

/** Hands the project out as a file, through the browser's own download. */
export function saveProjectFile(project: Project): void {
  const address = URL.createObjectURL(new Blob([writeProject(project)], { type: 'application/json' }))
  const link = document.createElement('a')
  link.href = address
  link.download = `${project.name.replace(/[^\p{L}\p{N} _-]/gu, '') || 'botgarten'}.botgarten.json`
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), 1000)
}
