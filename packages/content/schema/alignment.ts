import * as v from 'valibot'
import { checked, https } from './checked.ts'

const competence = v.strictObject({
  id: v.pipe(v.string(), v.regex(/^[a-z0-9-]+$/)),
  framework: v.picklist(['ai4k12', 'unesco', 'kmk']),
  /** As the framework itself numbers it. */
  ref: v.string(),
  /** To the letter as the framework has it in its own language (German for KMK, else English), in others our translation. */
  name: v.record(v.string(), v.string()),
  /** Where number and name were looked up. */
  checked,
})

const alignment = v.strictObject({
  /** Where each framework is published. */
  sources: v.record(v.string(), v.strictObject({ title: v.string(), address: https })),
  competences: v.array(competence),
  /** Ids of competences, by module (1 to 4) and by id of a card. */
  modules: v.record(v.string(), v.pipe(v.array(v.string()), v.minLength(1))),
  /** What a lesson shows for its competences, by the id of its plan and by language. */
  lessons: v.record(v.string(), v.record(v.string(), v.string())),
  cards: v.record(v.string(), v.pipe(v.array(v.string()), v.minLength(1))),
})

export type Alignment = v.InferOutput<typeof alignment>

/** Reads `content/materials/alignment.json`. @throws ValiError that names the place where the file is wrong. */
export const readAlignment = (json: unknown): Alignment => v.parse(alignment, json)
