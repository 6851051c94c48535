import { throwAway } from '#storage/bin.ts'
import {
  compareWithClass,
  compareWithVersions,
  noteCompared,
  seenMark,
  type InClass,
} from '#storage/class-versions.ts'
import { isThrownElsewhere, isWanted, noteThrownInClass, takeIn, type FromClass } from '#storage/outbox.ts'
import { parseProject, type Project } from '@botgarten/programs/project'
import * as v from 'valibot'
import { idInClass, idOnDevice, mark, pauseOf, type Pause } from './sending.ts'
import { read, type Ask, type Reply } from '#storage/ask.ts'

const revision = v.pipe(v.number(), v.integer(), v.minValue(1))
const hash = v.string()
const listed = v.object({
  projects: v.array(v.object({ id: v.string(), revision, hash })),
  bin: v.array(v.object({ id: v.string(), revision })),
  mark,
  known: v.boolean(),
})
const versions = v.object({ versions: v.array(v.object({ revision, hash, savedAt: v.number() })) })
const document = v.object({ revision, hash, savedAt: v.number(), project: v.unknown() })

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
  if (!found || !project) return null
  return { id, project, revision: found.revision, hash: found.hash, savedAt: found.savedAt }
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

/** Projects of the lab, by their ids on devices. */
const onDevice = <One extends { readonly id: string }>(all: readonly One[]): One[] =>
  all.flatMap((one) => {
    const id = idOnDevice(one.id)
    return id === null ? [] : [{ ...one, id }]
  })

/**
 * Asks the class for its list of projects, and compares this device with it: work that the class has lost is sent again.
 * @returns the list, or the reason why it did not arrive
 */
export async function compare(ask: Ask): Promise<InClass | Pause> {
  const seen = await seenMark()
  const reply = await ask('GET', `/projects${seen === null ? '' : `?mark=${encodeURIComponent(seen)}`}`)
  const found = read(listed, reply)
  if (!found) return pauseOf(reply)
  const list = { ...found, projects: onDevice(found.projects), bin: onDevice(found.bin) }
  for (const id of await compareWithClass(list)) {
    const all = await fetchVersions(ask, id)
    if (!all) return 'away'
    await compareWithVersions(id, all)
  }
  await noteCompared(list)
  return list
}

/**
 * Fetches a pupil's work from the class onto this device: what is not here, and what was left unchanged here. Work of this
 * device stays as it is.
 * @param only one project, whose page waits for it; all where none is named
 * @returns why it could not be fetched
 */
export async function fetchWork(ask: Ask, only?: string): Promise<Pause | null> {
  const list = await compare(ask)
  if (typeof list === 'string') return list
  const isMeant = ({ id }: { readonly id: string }) => only === undefined || id === only
  for (const { id, revision } of list.projects.filter(isMeant)) {
    if (!(await isWanted(id, revision))) continue
    const project = await fetchProject(ask, id)
    if (project) await takeIn(project)
  }
  // Projects that the child has deleted on another device move to the bin of this one too.
  for (const { id } of list.bin.filter(isMeant)) {
    if (!(await isThrownElsewhere(id))) continue
    await throwAway(id)
    await noteThrownInClass(id)
  }
  return null
}

/** So long a page waits for the class before it goes on without, in milliseconds. */
const timeout = 2500

export const soon = (act: Promise<unknown>, most = timeout): Promise<unknown> =>
  Promise.race([act, new Promise((resolve) => setTimeout(resolve, most))])
