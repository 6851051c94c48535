import { throwAway } from '#storage/bin.ts'
import { isThrownElsewhere, isWanted, noteThrownInClass, takeIn, type FromClass } from '#storage/outbox.ts'
import { parseProject, type Project } from '@botgarten/programs/project'
import * as v from 'valibot'
import { idInClass, idOnDevice, pauseOf, type Pause } from './sending.ts'
import { read, type Ask, type Reply } from '#storage/ask.ts'

const revision = v.pipe(v.number(), v.integer(), v.minValue(1))
const listed = v.object({
  projects: v.array(v.object({ id: v.string(), revision })),
  thrown: v.array(v.string()),
})
const versions = v.object({ versions: v.array(v.object({ revision, savedAt: v.number() })) })
const document = v.object({ revision, savedAt: v.number(), project: v.unknown() })

/** A project of the class, read as carefully as a stranger's file; null where it cannot be read. */
function projectIn(found: unknown): Project | null {
  try {
    return parseProject(found)
  } catch (cause) {
    console.warn('A project of the class cannot be read.', cause)
    return null
  }
}

function fromReply(id: string, reply: Reply): FromClass | null {
  const found = read(document, reply)
  const project = found && projectIn(found.project)
  return found && project && { id, project, revision: found.revision, savedAt: found.savedAt }
}

/** A project as the class has it, the newest where no revision is named; null where it cannot be had. */
export async function fetchProject(ask: Ask, id: string, at?: number): Promise<FromClass | null> {
  const path = `/projects/${idInClass(id)}`
  return fromReply(id, await ask('GET', at === undefined ? path : `${path}/versions/${at}`))
}

export type Version = v.InferOutput<typeof versions>['versions'][number]

/** What can be restored, the newest first; null where the class does not answer. */
export async function fetchVersions(ask: Ask, id: string): Promise<readonly Version[] | null> {
  return read(versions, await ask('GET', `/projects/${idInClass(id)}/versions`))?.versions ?? null
}

/**
 * Fetches a pupil's work from the class onto this device: what is not here, and what was left unchanged here. Work of this
 * device stays as it is.
 * @param only one project, whose page waits for it; all where none is named
 * @returns why it could not be fetched
 */
export async function fetchWork(ask: Ask, only?: string): Promise<Pause | null> {
  const reply = await ask('GET', '/projects')
  const all = read(listed, reply)
  if (!all) return pauseOf(reply)
  for (const one of all.projects) {
    const id = idOnDevice(one.id)
    if (id === null || (only !== undefined && id !== only)) continue
    if (!(await isWanted(id, one.revision))) continue
    const project = await fetchProject(ask, id)
    if (project) await takeIn(project)
  }
  await throwThese(all.thrown, only)
  return null
}

/** What the child has thrown away on another device lies in the bin of this one too. */
async function throwThese(thrown: readonly string[], only?: string): Promise<void> {
  for (const one of thrown) {
    const id = idOnDevice(one)
    if (id === null || (only !== undefined && id !== only) || !(await isThrownElsewhere(id))) continue
    await throwAway(id)
    await noteThrownInClass(id)
  }
}

/** So long a page waits for the class before it goes on without, in milliseconds. */
const timeout = 2500

export const soon = (act: Promise<unknown>, most = timeout): Promise<unknown> =>
  Promise.race([act, new Promise((resolve) => setTimeout(resolve, most))])
