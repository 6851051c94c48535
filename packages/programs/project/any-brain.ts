import type { Brain } from '@botgarten/learning/neural-network/brain'
import type { TableBrain } from '@botgarten/learning/q-senses'
import * as v from 'valibot'
import type { Project } from '../types.ts'
import { brainSchema } from './schema-brain.ts'
import { tableSchema } from './schema-tables.ts'

// In a file a table is a brain like a network. What runs them has little in common: in memory each kind has its own part.

const isTable = (data: unknown) =>
  typeof data === 'object' && data !== null && 'kind' in data && data.kind === 'table'

/** A network or a table, by its `kind`. */
export const anyBrain: v.GenericSchema<unknown, Brain | TableBrain> = v.lazy((data) =>
  isTable(data) ? tableSchema : brainSchema,
)

type Brains = Pick<Project, 'brains' | 'tables'>
interface InFile {
  readonly brains: { readonly [id: string]: Brain | TableBrain }
  /** As older versions wrote them. */
  readonly tables?: Project['tables']
}

/** Networks and tables, each in their own part. */
export function apart<Part extends InFile>(part: Part): Omit<Part, keyof InFile> & Brains {
  const all = Object.entries(part.brains)
  const networks = all.flatMap(([id, brain]) => (brain.kind === 'network' ? [[id, brain] as const] : []))
  const tables = all.flatMap(([id, brain]) => (brain.kind === 'table' ? [[id, brain] as const] : []))
  return {
    ...part,
    brains: Object.fromEntries(networks),
    ...(tables.length > 0 && { tables: { ...part.tables, ...Object.fromEntries(tables) } }),
  }
}

/** The same as a file holds it. */
export const inFile = <Part extends Brains>({ tables, ...part }: Part) =>
  tables ? { ...part, brains: { ...part.brains, ...tables } } : part
