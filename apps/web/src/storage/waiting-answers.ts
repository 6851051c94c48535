// Answers to questionnaires on their way to the class. They are the device's and nobody's: what waits is what is sent.
import { shuffled } from '@botgarten/answers'
import * as v from 'valibot'

const hex = v.pipe(v.string(), v.regex(/^[0-9a-f]{32}$/))

const waiting = v.strictObject({
  /** Of the form that the class is asked. */
  key: hex,
  /** By chance: what is sent twice is one. */
  id: hex,
  /** A bird and a number; null: none, or forgotten. */
  code: v.nullable(v.string()),
  values: v.record(v.string(), v.string()),
  /** Allows this answer, and does not lead to the pupil; missing for a form that was opened before there were tokens. */
  token: v.optional(v.strictObject({ input: v.string(), output: v.string() })),
})
/** What a child has answered, as it is sent. */
export type WaitingAnswer = v.InferOutput<typeof waiting>

const place = 'botgarten.answers'
const event = 'botgarten-answers'
/** Of a laptop that a class shares for a day without a network. */
const most = 60

/** Chance that nobody can foretell, from 0 to 1, 1 excluded. */
export const secretChance = (): number => crypto.getRandomValues(new Uint32Array(1))[0]! / 0x1_0000_0000

/** 32 hexadecimal digits by chance. */
export const newAnswerId = (): string =>
  [...crypto.getRandomValues(new Uint8Array(16))].map((byte) => byte.toString(16).padStart(2, '0')).join('')

export function waitingAnswers(): readonly WaitingAnswer[] {
  try {
    return v.parse(v.array(waiting), JSON.parse(localStorage.getItem(place) ?? '[]'))
  } catch {
    return []
  }
}

/** Their order says nothing of who answered first. */
function write(answers: readonly WaitingAnswer[]): boolean {
  try {
    if (answers.length === 0) localStorage.removeItem(place)
    else localStorage.setItem(place, JSON.stringify(shuffled(answers, secretChance).slice(0, most)))
    return true
  } catch {
    return false
  }
}

/** Takes an answer that is to be sent. @returns false where the device keeps nothing */
export function putAnswer(answer: WaitingAnswer): boolean {
  const isKept = write([...waitingAnswers(), answer])
  dispatchEvent(new Event(event))
  return isKept
}

export const dropAnswer = (id: string): void =>
  void write(waitingAnswers().filter((answer) => answer.id !== id))

/** Calls back when an answer was put, in this tab or another. @returns how to stop */
export function whenAnswerWaits(hear: () => void): () => void {
  const elsewhere = ({ key }: StorageEvent) => key === place && hear()
  addEventListener(event, hear)
  addEventListener('storage', elsewhere)
  return () => {
    removeEventListener(event, hear)
    removeEventListener('storage', elsewhere)
  }
}

const answered = v.object({ pupil: v.string(), keys: v.array(v.string()) })
const answeredPlace = 'botgarten.answered'

function answeredBy(pupil: string): readonly string[] {
  try {
    const found = v.parse(answered, JSON.parse(localStorage.getItem(answeredPlace) ?? 'null'))
    return found.pupil === pupil ? found.keys : []
  } catch {
    return []
  }
}

/** Has this pupil answered the form here? It is not asked again then. */
export const hasAnswered = (pupil: string, key: string): boolean => answeredBy(pupil).includes(key)

export function noteAnswered(pupil: string, key: string): void {
  try {
    const keys = [...new Set([...answeredBy(pupil), key])]
    localStorage.setItem(answeredPlace, JSON.stringify({ pupil, keys }))
  } catch {
    // It is asked once more then.
  }
}
