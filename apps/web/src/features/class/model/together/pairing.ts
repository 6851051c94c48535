import { parseProject, type Project } from '@botgarten/programs'
import * as v from 'valibot'
import { placeOf } from '#content/cards.ts'
import { keepNew } from '#lab/keep-new.ts'
import { read, type Ask } from '#storage/ask.ts'
import { keep, kept } from './kept.ts'

const invited = v.object({ id: v.string() })

export type InviteProblem = 'togetherPhoto' | 'togetherBusy' | 'togetherNotSent'

/** Asks a classmate to work on a project of this device. @returns why that was not possible */
export async function invite(
  ask: Ask,
  to: string,
  { id, project }: { readonly id: string; readonly project: Project },
): Promise<InviteProblem | null> {
  const { progress: _, ...whole } = project
  const reply = await ask('POST', `/pair?to=${encodeURIComponent(to)}`, whole)
  const pair = read(invited, reply)?.id
  if (pair !== undefined) {
    keep({ pair, project: id, card: placeOf(whole), pending: [], shown: [0] })
    return null
  }
  if (reply.kind !== 'refused') return 'togetherNotSent'
  if (reply.code === 'ownPhoto') return 'togetherPhoto'
  return reply.code === 'inPair' || reply.code === 'mateInPair' ? 'togetherBusy' : 'togetherNotSent'
}

const begun = v.object({ id: v.string(), project: v.unknown() })

/** Where the program of a pair is on this device; it is brought here where it is not. Null: not now. */
export async function placeOfPair(
  ask: Ask,
  pair: string,
): Promise<{ readonly id: string; readonly card: string } | null> {
  const known = kept()
  if (known?.pair === pair) return { id: known.project, card: known.card }
  const found = read(begun, await ask('GET', '/pair'))
  if (found?.id !== pair) return null
  const at = await keepNew(parseProject(found.project))
  if (at) keep({ pair, project: at.id, card: at.card, pending: [], shown: [0] })
  return at
}
