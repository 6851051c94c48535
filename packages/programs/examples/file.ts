import {
  headOfRow,
  mostOf,
  place,
  type Drive,
  type Examples,
} from '@botgarten/learning/neural-network/examples'
import * as v from 'valibot'
import { bytesIn, refuseOversize } from '../project/limits.ts'
import { examplesSchema } from '../project/schema-examples.ts'
import { idSchema } from '../project/schema-program.ts'
import type { NetworkOutline } from '../types.ts'
import { ExamplesError } from './error.ts'

// Examples as a file of their own: with what their neurons are, so that it is known where they fit, like a brain.

const mostBytes = 5_000_000

const neuron = v.object({ id: idSchema, kind: idSchema, port: idSchema })
const neurons = v.pipe(v.array(neuron), v.minLength(1), v.maxLength(1000))
const headSchema = v.object({
  botgarten: v.literal('examples'),
  version: v.literal(1),
  neurons: v.object({ inputs: neurons, outputs: neurons }),
  drives: v.unknown(),
  rows: v.unknown(),
})

/** `kind`: type of the neuron's block. */
export type ExamplesFile = Omit<Examples, 'inputs' | 'outputs'> & {
  readonly botgarten: 'examples'
  readonly neurons: { readonly inputs: readonly Kind[]; readonly outputs: readonly Kind[] }
}
type Kind = v.InferOutput<typeof neuron>

/** Examples as a file, with the columns of this network's neurons. */
export function examplesFile(examples: Examples, network: NetworkOutline): ExamplesFile {
  const ids = [...examples.inputs, ...examples.outputs]
  const known = kindsOf(network)
  const columns = [...known.inputs, ...known.outputs].map(({ id }) => ids.indexOf(id))
  const rows = examples.rows.map((row) => [
    ...row.slice(0, headOfRow),
    ...columns.map((column) => (column < 0 ? null : (row[headOfRow + column] ?? null))),
  ])
  return { botgarten: 'examples', version: 1, neurons: known, drives: examples.drives, rows }
}

const kindsOf = ({ inputs, outputs }: NetworkOutline) => {
  const kinds = (all: NetworkOutline['inputs']): Kind[] =>
    all.map(({ id, type, fields, look }) => ({
      ...{ id, kind: type },
      port: look.port === undefined ? '' : (fields[look.port] ?? '').slice(0, 100),
    }))
  return { inputs: kinds(inputs), outputs: kinds(outputs) }
}

/**
 * Examples from a file's text, of which nothing is trusted. `first`: of too many rows or drives the first ones are taken.
 * @throws {ExamplesError} and nothing else
 */
export function parseExamplesFile(text: string, first = false): ExamplesFile {
  if (text.length > mostBytes || bytesIn(text) > mostBytes)
    throw new ExamplesError('tooBig', { most: mostBytes / 1_000_000 })
  const data = dataIn(text)
  const head = v.safeParse(headSchema, data, { abortEarly: true })
  if (!head.success) throw new ExamplesError('notExamples')
  const { neurons: own, ...given } = head.output
  const { drives, rows } = first ? firstOf(given.drives, given.rows) : given
  refuseMany(drives, rows)
  const ids = (kinds: readonly Kind[]) => kinds.map(({ id }) => id)
  const table = { version: 1, inputs: ids(own.inputs), outputs: ids(own.outputs), drives, rows }
  const result = v.safeParse(examplesSchema, table, { abortEarly: true })
  if (!result.success) throw errorOf(result.issues[0])
  const { version, drives: whole, rows: all } = result.output
  return { botgarten: 'examples', version, neurons: own, drives: whole, rows: all }
}

function dataIn(text: string): unknown {
  let data: unknown
  try {
    data = JSON.parse(text)
  } catch {
    throw new ExamplesError('notJson')
  }
  try {
    refuseOversize(data)
  } catch {
    throw new ExamplesError('notExamples')
  }
  const { botgarten } = (data ?? {}) as { readonly botgarten?: unknown }
  if (typeof botgarten === 'number') throw new ExamplesError('isAProject')
  return data
}

function refuseMany(drives: unknown, rows: unknown): void {
  const most = (list: unknown, limit: number) => Array.isArray(list) && list.length > limit
  if (most(rows, mostOf.rows)) throw new ExamplesError('manyRows', { most: mostOf.rows })
  if (most(drives, mostOf.drives)) throw new ExamplesError('manyDrives', { most: mostOf.drives })
}

/** As many rows of as many drives as there may be; what is no list stays as it is. */
function firstOf(drives: unknown, rows: unknown): { readonly drives: unknown; readonly rows: unknown } {
  if (!Array.isArray(drives) || !Array.isArray(rows)) return { drives, rows }
  const isGone = (row: unknown) => Array.isArray(row) && Number(row[place.drive]) >= mostOf.drives
  return {
    drives: drives.slice(0, mostOf.drives),
    rows: rows.filter((row) => !isGone(row)).slice(0, mostOf.rows),
  }
}

function errorOf({ path }: v.BaseIssue<unknown>): ExamplesError {
  const [part, at] = path?.map(({ key }) => key) ?? []
  return part === 'rows' && typeof at === 'number'
    ? new ExamplesError('badRow', { row: at + 1 })
    : new ExamplesError('notExamples')
}

/**
 * The examples of a file under the names of this network: neurons that are called the same and are of the same kind, or else all in
 * their order, kind by kind.
 * @throws {ExamplesError} `otherNetwork`
 */
export function fitExamples(file: ExamplesFile, network: NetworkOutline): Examples {
  const here = kindsOf(network)
  const inputs = namesFor(file.neurons.inputs, here.inputs)
  const outputs = namesFor(file.neurons.outputs, here.outputs)
  if (!inputs || !outputs)
    throw new ExamplesError('otherNetwork', { there: said(file.neurons), here: said(here) })
  return { version: 1, inputs, outputs, drives: file.drives, rows: file.rows }
}

function namesFor(theirs: readonly Kind[], ours: readonly Kind[]): readonly string[] | null {
  if (theirs.length !== ours.length) return null
  const named = theirs.every(({ id, kind }) => ours.some((one) => one.id === id && one.kind === kind))
  if (named) return theirs.map(({ id }) => id)
  return theirs.every(({ kind }, at) => ours[at]!.kind === kind) ? ours.map(({ id }) => id) : null
}

const said = ({ inputs, outputs }: ExamplesFile['neurons']) => `${inputs.length} → ${outputs.length}`

/** How many rows still fit behind these examples; 0: no drive or no row does. */
export const roomBehind = ({ drives, rows }: Examples): number =>
  drives.length < mostOf.drives ? Math.max(0, mostOf.rows - rows.length) : 0

/**
 * Examples behind others of the same network. What a drive is called there may be taken here: then it gets a number. `fits`: of too
 * many the first ones are taken.
 * @throws {ExamplesError} where together they are too many
 */
export function joinExamples(first: Examples, added: Examples, fits = false): Examples {
  const second = fits ? cutTo(added, mostOf.drives - first.drives.length, roomBehind(first)) : added
  const taken = new Set(first.drives.map(({ id }) => id))
  const drives = second.drives.map((drive): Drive => {
    let id = drive.id
    for (let number = 2; taken.has(id); number++) id = `${drive.id} ${number}`
    taken.add(id)
    return { ...drive, id }
  })
  const ids = [...second.inputs, ...second.outputs]
  const columns = [...first.inputs, ...first.outputs].map((id) => ids.indexOf(id))
  const rows = second.rows.map((row) => [
    row[place.drive]! + first.drives.length,
    ...row.slice(1, headOfRow),
    ...columns.map((column) => (column < 0 ? null : (row[headOfRow + column] ?? null))),
  ])
  const joined = { ...first, drives: [...first.drives, ...drives], rows: [...first.rows, ...rows] }
  refuseMany(joined.drives, joined.rows)
  return joined
}

const cutTo = ({ drives, rows, ...rest }: Examples, mostDrives: number, mostRows: number): Examples => ({
  ...{ ...rest, drives: drives.slice(0, mostDrives) },
  rows: rows.filter((row) => row[place.drive]! < mostDrives).slice(0, mostRows),
})
