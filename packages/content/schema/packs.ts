import * as v from 'valibot'
import { copies } from './plan.ts'
import type { Copies } from './planTypes.ts'

/** What is printed together and belongs to no one lesson. */
export interface FixedPack {
  readonly id: string
  readonly title: { readonly [language: string]: string }
  readonly copies: readonly Copies[]
}

const packs: v.GenericSchema<unknown, readonly FixedPack[]> = v.array(
  v.strictObject({
    id: v.pipe(v.string(), v.regex(/^[a-z][a-z-]*$/)),
    title: v.record(v.string(), v.string()),
    copies,
  }),
)

/** Reads `content/materials/packs.json`. @throws ValiError that names the place where the file is wrong. */
export const readPacks = (json: unknown): readonly FixedPack[] => v.parse(packs, json)

const synonyms = v.record(v.string(), v.array(v.pipe(v.array(v.string()), v.minLength(2))))

/** Reads `content/materials/synonyms.json`: groups of words for the same thing, by language. @throws ValiError */
export const readSynonyms = (json: unknown) => v.parse(synonyms, json)
