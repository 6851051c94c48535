// Tokens of questionnaires that were opened and not yet answered. Until a pupil has answered, the device knows which token is
// whose: a page that is loaded again must ask for the same one.
import type { BlindedInput } from '@botgarten/answers/tokens'
import * as v from 'valibot'

const bytes = v.pipe(v.string(), v.regex(/^[0-9a-f]{64}$/))
const started = v.object({
  ...{ pupil: v.string(), key: v.string() },
  made: v.object({ input: bytes, blind: bytes, blinded: bytes }),
})
type Started = v.InferOutput<typeof started>

const place = 'botgarten.answerTokens'
/** Pupils who share a laptop, each with a form. */
const most = 60

function all(): readonly Started[] {
  try {
    return v.parse(v.array(started), JSON.parse(localStorage.getItem(place) ?? '[]'))
  } catch {
    return []
  }
}

function write(rows: readonly Started[]): void {
  try {
    if (rows.length === 0) localStorage.removeItem(place)
    else localStorage.setItem(place, JSON.stringify(rows.slice(-most)))
  } catch {
    // The page that is open knows it, and the teacher can allow another one.
  }
}

const isOf = (pupil: string, key: string) => (row: Started) => row.pupil === pupil && row.key === key

/**
 * The blinded input of a pupil's token for a form.
 * @param make called if the device stores no input for this pupil and form
 */
export function startedToken(pupil: string, key: string, make: () => BlindedInput): BlindedInput {
  const found = all().find(isOf(pupil, key))
  if (found) return found.made
  const made = make()
  write([...all(), { pupil, key, made }])
  return made
}

/** The pupil has answered: from now on nothing here leads from the pupil to the answer. */
export const forgetToken = (pupil: string, key: string): void =>
  write(all().filter((row) => !isOf(pupil, key)(row)))
