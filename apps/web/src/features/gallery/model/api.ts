import { parseProject, ProjectError, writeProject, type Project } from '@botgarten/programs/project'
import * as v from 'valibot'
import { item, looked, type Looked } from '#figures/gallery/item.ts'
import { read, type Ask, type Reply } from '#storage/ask.ts'

export type Order = 'newest' | 'hearts' | 'mine'

const page = v.object({ total: v.number(), items: v.array(item) })
type Page = v.InferOutput<typeof page>

/** Why something did not come or go. `away`: the class cannot be reached · `off`: there is no gallery (any more). */
export type Problem =
  | 'away'
  | 'off'
  | 'gone'
  | 'title'
  | 'tooBig'
  | 'full'
  | 'classFull'
  | 'pupilFull'
  | 'tooManyHearts'
  | 'notKept'
  | 'unread'

const problems: { readonly [code: string]: Problem } = {
  galleryOff: 'off',
  noSuchShared: 'gone',
  title: 'title',
  tooBig: 'tooBig',
  projectRefused: 'tooBig',
  galleryFull: 'full',
  classFull: 'classFull',
  pupilFull: 'pupilFull',
  tooManyHearts: 'tooManyHearts',
}

const problemOf = (reply: Reply): Problem =>
  reply.kind === 'refused' ? (problems[reply.code] ?? 'away') : 'away'

export async function fetchPage(ask: Ask, order: Order, from: number): Promise<Page | Problem> {
  const reply = await ask('GET', `/gallery?by=${order}&from=${from}`)
  return read(page, reply) ?? problemOf(reply)
}

/** Something shared, with its project: read as carefully as a stranger's file. */
export interface Opened extends Omit<Looked, 'project'> {
  readonly project: Project
}

export async function fetchShared(ask: Ask, id: string): Promise<Opened | Problem> {
  const reply = await ask('GET', `/gallery/${id}`)
  const found = read(looked, reply)
  if (!found) return problemOf(reply)
  try {
    return { ...found, project: parseProject(found.project) }
  } catch (cause) {
    if (!(cause instanceof ProjectError)) throw cause
    console.warn('Something shared cannot be read.', cause)
    return 'unread'
  }
}

const sent = v.object({ waiting: v.boolean() })

/** Shares a snapshot under a title. @param share sent twice under one id, it is one */
export async function sendShared(
  ask: Ask,
  share: string,
  project: Project,
  title: string,
): Promise<{ readonly waiting: boolean } | Problem> {
  const { progress: _, raced: _raced, ...snapshot } = project
  const reply = await ask('POST', `/gallery?share=${share}`, writeProject({ ...snapshot, name: title }))
  return read(sent, reply) ?? problemOf(reply)
}

const hearts = v.object({ hearts: v.number(), mine: v.boolean() })

export async function giveHeart(
  ask: Ask,
  id: string,
  on: boolean,
): Promise<v.InferOutput<typeof hearts> | Problem> {
  const reply = await ask('PUT', `/gallery/${id}/heart`, { on })
  return read(hearts, reply) ?? problemOf(reply)
}

export async function takeOut(ask: Ask, id: string): Promise<Problem | null> {
  const reply = await ask('DELETE', `/gallery/${id}`)
  return reply.kind === 'done' ? null : problemOf(reply)
}
