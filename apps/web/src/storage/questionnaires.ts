import { readAnswer, type Answer, type PaperCounts, type Release } from '@botgarten/answers'
import { readFormFile, writeFormFile, type LoadedForm } from '@botgarten/content/questionnaires'
import * as v from 'valibot'

/** What is being asked on this device right now. */
interface AskingNow {
  readonly form: string
  readonly grade: number
}

/** All that this device holds of questionnaires. */
export interface Kept {
  /** In random order. */
  readonly answers: readonly Answer[]
  readonly release: Release
  readonly paper: readonly PaperCounts[]
  readonly asking: AskingNow | null
  /** Forms that were changed here. */
  readonly forms: readonly LoadedForm[]
}

const nothing: Kept = {
  ...{ answers: [], paper: [], asking: null, forms: [] },
  release: { batches: [], atoms: [], comparisons: [] },
}

const name = v.pipe(v.string(), v.maxLength(40))
const ids = v.array(name)
const band = v.picklist(['3-4', '5-6', '7-9', '10-12'])
const count = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(1000))
const atoms = v.array(v.object({ form: name, bands: v.pipe(v.array(band), v.minLength(1)), ids }))

const kept = v.object({
  answers: v.pipe(
    v.array(v.unknown()),
    v.transform((all) => all.map(readAnswer)),
  ),
  release: v.object({
    ...{ batches: atoms, atoms },
    comparisons: v.array(v.object({ before: name, after: name, pairs: v.array(v.tuple([name, name])) })),
  }),
  paper: v.array(
    v.object({
      ...{ form: name, bands: v.pipe(v.array(band), v.minLength(1)), n: count },
      counts: v.record(v.string(), v.array(count)),
      open: v.record(v.string(), v.array(v.string())),
    }),
  ),
  asking: v.nullable(v.object({ form: name, grade: count })),
  forms: v.pipe(
    v.array(v.unknown()),
    v.transform((all) => all.map(readFormFile)),
  ),
})

/** Where it lies: it is one collection for all who use the device. */
const place = 'botgarten.questionnaires'

/** What this device holds; nothing where the browser keeps nothing, or something that is none of it. */
export function readKept(): Kept {
  try {
    const text = localStorage.getItem(place)
    return text === null ? nothing : v.parse(kept, JSON.parse(text))
  } catch {
    return nothing
  }
}

/** Keeps it. False where the device has no room, or keeps nothing. */
export function writeKept(all: Kept): boolean {
  const forms = all.forms.map((one) => JSON.parse(writeFormFile(one)) as unknown)
  try {
    localStorage.setItem(place, JSON.stringify({ ...all, forms }))
    return true
  } catch {
    return false
  }
}
