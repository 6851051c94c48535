import type { Block, Mutation } from '@botgarten/blocks'
import { isReserved } from '../project/limits.ts'
import { flag, wrapsByItself } from './repetitions.ts'
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
  const wanted = id === '' || id.length > 150 || isReserved(id) ? type : id
  let own = wanted
  let number = ids.get(wanted) ?? 0
  while (ids.has(own) || isReserved(own)) own = `${wanted}_${++number + 1}`
  ids.set(wanted, number)
  if (own !== wanted) ids.set(own, 0)
  return own
}

function readParts(element: Element, type: string, ids: Ids): Parts {
  const parts: Parts = { fields: {}, values: {}, statements: {}, flags: {}, hide: [] }
  for (const child of element.children) {
    const read = Object.hasOwn(readers, child.name) ? readers[child.name] : undefined
    if (!read) throw notOpenRoberta(`"${child.name}" does not belong into a block.`)
    read(child, parts, ids)
  }
  refuseText(element)
  const wrapped = element.children.some(({ name }) => name === 'repetitions')
  const alone = Object.keys(parts.values).length + Object.keys(parts.statements).length === 0
  if (wrapped !== wrapsByItself({ type, mutation: parts.mutation }) && (wrapped || !alone))
    parts.flags[flag] = String(wrapped)
  return parts
}

export function refuseText({ name, text }: Element): void {
  if (text.trim() !== '') throw notOpenRoberta(`There is text in "${name}".`)
}

type Reader = (element: Element, parts: Parts, ids: Ids) => void

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
  repetitions(element, parts, ids) {
    refuseText(element)
    for (const child of element.children) {
      if (child.name === 'value' || child.name === 'statement') readers[child.name]!(child, parts, ids)
      else throw notOpenRoberta(`"${child.name}" does not belong into repetitions.`)
    }
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
  value(element, { values, flags }, ids) {
    refuseText(element)
    const { name } = element.attributes
    const blocks = element.children.map((child) => readBlock(child, ids))
    const [first, second] = blocks
    const above = second ?? first
    if (!above) return
    const two = blocks.length === 2 && first?.shadow === true && second?.shadow !== true
    if (second && !two) throw notOpenRoberta(`Two blocks are plugged into "${name}".`)
    put(values, name, above)
    if (two) flags[`under.${name}`] = JSON.stringify(first)
  },
  statement(element, { statements }, ids) {
    put(statements, element.attributes['name'], readRow(element, ids))
  },
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
  if (name === undefined || name === '') throw notOpenRoberta(`${what} has no name.`)
  if (isReserved(name)) throw notOpenRoberta(`${what} must not be called "${name}".`)
  return name
}
