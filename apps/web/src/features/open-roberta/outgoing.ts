import type { Project } from '@botgarten/programs'
import { fileFrom, fileInSteps, strangeness } from '@botgarten/programs/open-roberta'
import { handOut } from '#storage/handout.ts'

/** A robot's program on its way to Open Roberta, which does not know all of it. */
export interface Outgoing extends ReturnType<typeof strangeness> {
  readonly project: Project
  readonly robot: string
}

export const outgoingOf = (project: Project, robot: string): Outgoing => ({
  ...strangeness(project, robot),
  ...{ project, robot },
})

/** Letters that a file may have in its name everywhere. */
const plain = (name: string) =>
  name
    .replace(/[^\p{L}\p{N} _-]/gu, '')
    .trim()
    .slice(0, 80) || 'botgarten'

/**
 * Every program of these projects as a file: one a robot, and in `folder` once more those whose network can be said in
 * Open Roberta's own blocks. Names that come again are numbered.
 */
export function filesOf(projects: readonly Project[], folder: string): { readonly [path: string]: string } {
  const files: Record<string, string> = {}
  for (const project of projects)
    for (const { id, name } of robotsOf(project)) {
      const free = freeName(name, files)
      files[`${free}.xml`] = fileFrom(project, id)
      if (strangeness(project, id).network === 'steps')
        files[`${plain(folder)}/${free}.xml`] = fileInSteps(project, id)
    }
  return files
}

/** Robots that share a program need no file each. */
function robotsOf({ name, world, programs }: Project) {
  const own = world.robots.filter(
    ({ program }, at, all) =>
      Object.hasOwn(programs, program) && all.findIndex((one) => one.program === program) === at,
  )
  return own.map(({ id }, at) => ({ id, name: plain(at === 0 ? name : `${name} ${at + 1}`) }))
}

function freeName(name: string, files: { readonly [path: string]: string }): string {
  for (let number = 1; ; number++) {
    const free = number === 1 ? name : `${name} ${number}`
    if (!Object.keys(files).some((path) => path.toLowerCase() === `${free}.xml`.toLowerCase())) return free
  }
}

/** Hands a program out as a file; `inSteps`: with its network in Open Roberta's own blocks. */
export const save = ({ project, robot }: Outgoing, inSteps = false): void =>
  handOut(project.name, inSteps ? fileInSteps(project, robot) : fileFrom(project, robot), 'xml')
