import { shownName } from '#content/names.ts'
import { list, load } from '#storage/projects.ts'

/** A project of this device that can be sent. */
export interface OwnProject {
  readonly id: string
  readonly name: string
  /** As its file has it. */
  readonly file: () => Promise<string>
}

/** What lies on this device, the newest first, without cards that are still being made. */
export async function ownProjects(): Promise<readonly OwnProject[]> {
  const { projects } = await list()
  const finished = projects.filter(({ project }) => !project.ownCard?.draft)
  return finished.map((one) => ({ id: one.id, name: shownName(one), file: () => fileOf(one.id) }))
}

async function fileOf(id: string): Promise<string> {
  const [found, { playedFrom, writeProjectFile }] = await Promise.all([
    load(id),
    import('@botgarten/programs/project'),
  ])
  if (!found) throw new Error(`The project ${id} is no more.`)
  // Children get a card without its solution.
  return writeProjectFile(found.project.ownCard ? playedFrom(found.project) : found.project)
}
