import { answerIdOf, blindInput, tokenOf, type Token } from '@botgarten/answers/tokens'
import * as v from 'valibot'
import type { Account } from '#storage/account.ts'
import { startedToken } from '#storage/answer-tokens.ts'
import { newAnswerId } from '#storage/waiting-answers.ts'
import type { ClassQuestion } from './class-question.ts'

/** Allows a device one answer to a form. */
export interface Permit {
  /** Of the answer. */
  readonly id: string
  /** Missing where the form was opened before there were tokens. */
  readonly token?: Token
}

/**
 * Why there is no token. `given`: the pupil got it on another device or in another browser · `marked`: the class used a key of its
 * own for this pupil, by which it could recognise the answer · `away`: the class cannot be reached.
 */
export type NoPermit = 'given' | 'marked' | 'away'

const keyAnswer = v.object({ key: v.string(), publicKey: v.nullable(v.string()) })
const evaluation = v.object({ evaluated: v.string(), proof: v.string() })

/** The key of the form, requested without a cookie: the class does not know which child's page compares it. */
async function publicKeyOf(classId: string) {
  const reply = await fetch(`/api/class/answers/key?class=${classId}`, { credentials: 'omit' })
  return reply.ok ? v.parse(keyAnswer, await reply.json()) : null
}

/** Fetches the one token of a pupil for a form. A page that is loaded again gets the same. */
export async function permitFor(
  { pupil, class: classId }: Account,
  { key, publicKey }: ClassQuestion,
): Promise<Permit | NoPermit> {
  if (publicKey === null) return { id: newAnswerId() }
  try {
    const shared = await publicKeyOf(classId)
    if (!shared) return 'away'
    if (shared.key !== key || shared.publicKey !== publicKey) return 'marked'
    const made = startedToken(pupil, key, () => blindInput())
    const reply = await fetch('/api/class/me/questionnaire/token', {
      ...{ method: 'POST', body: JSON.stringify({ key, blinded: made.blinded }) },
      headers: { 'content-type': 'application/json', 'botgarten-pupil': pupil },
    })
    if (reply.status === 409) return 'given'
    if (!reply.ok) return 'away'
    const evaluated = v.parse(evaluation, await reply.json())
    const token = proven(() => tokenOf(made, evaluated, publicKey))
    return token ? { id: answerIdOf(token), token } : 'marked'
  } catch {
    return 'away'
  }
}

/** @returns null if the proof does not hold */
function proven(make: () => Token): Token | null {
  try {
    return make()
  } catch {
    return null
  }
}
