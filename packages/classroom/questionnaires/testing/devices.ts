import {
  answerIdOf,
  blindInput,
  tokenOf,
  type BlindedInput,
  type Evaluation,
  type Token,
} from '@botgarten/answers/tokens'
import type { Browser } from '../../testing/browser.ts'

/** Allows a device one answer. */
export interface Permit {
  /** Of the form. */
  readonly key: string
  readonly id: string
  readonly token: Token
}

interface Asked {
  readonly key: string
  readonly publicKey: string
}

/** The form that is open for a pupil, as the page gets it. */
export const askedOn = async (pupil: Browser): Promise<Asked> =>
  (await pupil.get('/me/questionnaire?tokens')).body as Asked

/** Fetches the token of a pupil, as the page does. */
export async function permitOf(pupil: Browser, made: BlindedInput = blindInput()): Promise<Permit> {
  const { key, publicKey } = await askedOn(pupil)
  const { status, body } = await pupil.post('/me/questionnaire/token', { key, blinded: made.blinded })
  if (status !== 200) throw new Error(`There is no token: ${status} ${JSON.stringify(body)}`)
  const token = tokenOf(made, body as Evaluation, publicKey)
  return { key, id: answerIdOf(token), token }
}
