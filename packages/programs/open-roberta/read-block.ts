import type { Block, Mutation } from '@botgarten/blocks'
import { isReserved } from '../project/limits.ts'
import { flag, inBranches, wrapsByItself } from './repetitions.ts'
import { notOpenRoberta, type Element } from './tree.ts'

/**
 * Ids of a part of the file, each with how often it was wanted: a second block with the same one gets another, and keeps its
 * own among its flags.
 */
export type Ids = Map<string, number>

type Strings = Record<string, string>
interface Parts {
  readonly fields: Strings
  readonly values: Record<string, Block>
  readonly statements: Record<string, readonly Block[]>
  readonly flags: Strings
  readonly hide: string[]
  mutation?: Mutation
  comment?: string
  data?: string
}

/** One block with all that hangs in it. Its type may be unknown here. @throws {ProjectError} */
function readBlock(element: Element, ids: Ids): Block {
  const { type = '', id = '', inline, collapsed, disabled, ...others } = element.attributes
  const { flags, ...parts } = readParts(element, type, ids)
  const states = { inline: truth(inline), collapsed: truth(collapsed), disabled: truth(disabled) }
  for (const [name, text] of Object.entries({ inline, collapsed, disabled }))
    if (text !== undefined && truth(text) === undefined) flags[name] = text
  Object.assign(flags, others)
  if (type === '') throw notOpenRoberta('A block has no type.')
  const own = freshId(nameOf(type, 'A block'), id, ids)
  if (own !== id) flags['id'] = id
  return {
    ...{ id: own, type },
    ...filled({ ...parts, flags }),
    ...defined(states),
    ...((element.name === 'shadow' || others['shadow'] === 'true') && { shadow: true }),
  }
}

const truth = (text: string | undefined) => (text === 'true' ? true : text === 'false' ? false : undefined)

const defined = <Record extends object>(record: Record) =>
  Object.fromEntries(Object.entries(record).filter(([, value]) => value !== undefined))

/** Without what is empty. */
const filled = (parts: object) =>
  Object.fromEntries(
    Object.entries(parts).filter(
      ([, part]: [string, string | object]) => typeof part === 'string' || Object.keys(part).length > 0,
    ),
  )

function freshId(type: string, id: string, ids: Ids): string {
  const wanted = (id === '' || id.length > 150 || isReserved(id) ? type : id).slice(0, 150)
  let own = wanted
  let number = ids.get(wanted) ?? 0
  while (ids.has(own) || isReserved(own)) own = `${wanted}_${++number + 1}`
  ids.set(wanted, number)
  if (own !== wanted) ids.set(own, 0)
  return own
}

function readParts(element: Element, type: string, ids: Ids): Parts {
  const parts: Parts = { fields: {}, values: {}, statements: {}, flags: {}, hide: [] }
  refuseText(element)
  for (const child of element.children) {
    if (isInput(child) || child.name === 'repetitions') continue
    const read = Object.hasOwn(readers, child.name) ? readers[child.name] : undefined
    if (!read) throw notOpenRoberta(`"${child.name}" does not belong into a block.`)
    read(child, parts)
  }
  const wrapped = element.children.some(({ name }) => name === 'repetitions')
  const inputs = inputsIn(element, wrapped)
  for (const input of inputs) readInput(input, parts, ids)
  if (wrapped !== wrapsByItself({ type, mutation: parts.mutation }) && (wrapped || inputs.length > 0))
    parts.flags[flag] = String(wrapped)
  return parts
}

const isInput = ({ name }: Element) => name === 'value' || name === 'statement'

/** In the order in which they are written again, so that of two blocks with one id the same one keeps it. */
function inputsIn({ children }: Element, wrapped: boolean): readonly Element[] {
  const all = children.flatMap((child) => {
    if (child.name !== 'repetitions') return isInput(child) ? [child] : []
    refuseText(child)
    const other = child.children.find((one) => !isInput(one))
    if (other) throw notOpenRoberta(`"${other.name}" does not belong into repetitions.`)
    return child.children
  })
  const named = all.map((element) => ({
    element,
    kind: element.name === 'value' ? ('value' as const) : ('statement' as const),
    name: element.attributes['name'] ?? '',
  }))
  const values = named.toSorted((a, b) => Number(a.kind === 'statement') - Number(b.kind === 'statement'))
  return (wrapped ? inBranches(values) : values).map(({ element }) => element)
}

export function refuseText({ name, text }: Element): void {
  if (text.trim() !== '') throw notOpenRoberta(`There is text in "${name}".`)
}

type Reader = (element: Element, parts: Parts) => void

/** What is said at a block: its text, and where it is shown among the flags. */
function noteIn({ name, attributes, text, children }: Element, { flags }: Parts): string {
  refuseChildren(name, children)
  for (const [attribute, value] of Object.entries(attributes)) put(flags, `${name}.${attribute}`, value)
  return text
}
const noted: Reader = (element, parts) => put(parts.flags, element.name, noteIn(element, parts))

const readers: { readonly [name: string]: Reader } = {
  mutation(element, parts) {
    refuseText(element)
    if (parts.mutation) throw notOpenRoberta('A block has two mutations.')
    const args = element.children.map(readArg)
    parts.mutation = { attrs: element.attributes, ...(args.length > 0 && { args }) }
  },
  field({ name, attributes, text, children }, { fields }) {
    refuseChildren(name, children)
    put(fields, attributes['name'], text)
  },
  comment(element, parts) {
    if (parts.comment !== undefined) throw notOpenRoberta('A block has two comments.')
    parts.comment = noteIn(element, parts)
  },
  error: noted,
  warning: noted,
  data({ name, text, children }, parts) {
    refuseChildren(name, children)
    if (parts.data !== undefined) throw notOpenRoberta('A block has data twice.')
    parts.data = text
  },
  hide({ attributes: { name, value } }, { hide, flags }) {
    hide.push(nameOf(name, 'What is hidden'))
    if (value !== undefined) flags[`hide.${name}`] = value
  },
}

function readInput(element: Element, parts: Parts, ids: Ids): void {
  const { name } = element.attributes
  if (element.name === 'statement') put(parts.statements, name, readRow(element, ids))
  else readValue(element, parts, ids)
}

function readValue(element: Element, { values, flags }: Parts, ids: Ids): void {
  refuseText(element)
  const { name } = element.attributes
  const [first, second, ...more] = element.children.map((child) => readBlock(child, ids))
  const above = second ?? first
  if (!above) return
  const under = second && more.length === 0 && first?.shadow === true && second.shadow !== true
  if (second && !under) throw notOpenRoberta(`Two blocks are plugged into "${name}".`)
  put(values, name, above)
  if (under) flags[`under.${name}`] = JSON.stringify(first)
}

/** Blocks that stand one after the other. */
export function readRow(element: Element, ids: Ids): readonly Block[] {
  refuseText(element)
  return element.children.map((child) => {
    if (child.name !== 'block') throw notOpenRoberta(`"${child.name}" stands where a block should.`)
    return readBlock(child, ids)
  })
}

function readArg({ name, attributes, children }: Element) {
  if (name !== 'arg') throw notOpenRoberta(`"${name}" does not belong into a mutation.`)
  refuseChildren(name, children)
  return { name: attributes['name'] ?? '', type: attributes['type'] ?? '' }
}

function refuseChildren(name: string, children: readonly Element[]): void {
  if (children.length > 0) throw notOpenRoberta(`There is an element in "${name}".`)
}

function put<Value>(record: Record<string, Value>, name: string | undefined, value: Value): void {
  const key = nameOf(name, 'A part of a block')
  if (Object.hasOwn(record, key)) throw notOpenRoberta(`A block has two parts called "${key}".`)
  record[key] = value
}

function nameOf(name: string | undefined, what: string): string {
  if (name === undefined) throw notOpenRoberta(`${what} has no name.`)
  if (isReserved(name)) throw notOpenRoberta(`${what} must not be called "${name}".`)
  return name
}
