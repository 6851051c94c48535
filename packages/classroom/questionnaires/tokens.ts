import { answerIdOf, outputOf, type FormKey, type Token } from '@botgarten/answers/tokens'
import * as v from 'valibot'
import type { AskingRow } from '../database/answers/tables.ts'
import { sameHash } from '../hashes.ts'
import { Refusal } from '../refusal.ts'

const hex = (bytes: number) => v.pipe(v.string(), v.regex(/^[0-9a-f]*$/), v.length(2 * bytes))
export const element = hex(32)
/** As a device sends it. */
export const token = v.strictObject({ input: hex(32), output: hex(64) })

/** The key of a form; null: it was opened before there were tokens. */
export const formKeyOf = ({ secretKey, publicKey }: AskingRow): FormKey | null =>
  secretKey === null || publicKey === null ? null : { secretKey, publicKey }

/**
 * Lets an answer pass that has the token of a form. Its id is a keyed hash of the token, so the table of answers is also the
 * table of tokens that are spent: no time, no order, and deleted with the form.
 * @param id of the answer
 * @throws Refusal 422 without a token, and for one that this form's key has not made
 */
export function checkToken(asking: AskingRow, id: string, sent: Token | undefined): void {
  const key = formKeyOf(asking)
  if (key === null) return
  if (!sent) throw new Refusal(422, 'tokenMissing')
  if (answerIdOf(sent) !== id || !sameHash(outputOf(key, sent.input), sent.output))
    throw new Refusal(422, 'tokenRefused')
}
