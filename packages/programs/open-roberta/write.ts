import * as v from 'valibot'
import type { Block } from '@botgarten/blocks'
import { isReserved } from '../project/limits.ts'
import { blockSchema } from '../project/schema-program.ts'
import type { Program, Stack } from '../types.ts'
import { flag, inBranches, isWrapped } from './repetitions.ts'
import { robots } from './read.ts'
import { element, entriesByName, namespace as xmlns, textOf } from './xml.ts'

const fresh = { xmlns, robottype: 'ev3', xmlversion: '3.1', description: '', tags: '' }

/** An Open Roberta file with the program and its configuration; read again, it is the same program. */
export function writeOpenRoberta({ stacks, config, raw }: Program): string {
  const program = element('program', {}, set(stacks, raw?.attributes))
  const setUp =
    raw && !raw.config && config.stacks.length === 0 ? '' : set(config.stacks, raw?.config ?? raw?.attributes)
  return element('export', rootOf(raw?.root), program + (setUp && element('config', {}, setUp)))
}

type Attributes = { readonly [name: string]: string }

const rootOf = (root: Attributes = { xmlns }): Attributes =>
  root['xmlns'] === undefined ? root : { ...root, xmlns }

/** A project may name any robot; its program is written for the EV3. */
const forRobot = ({ robottype, ...others }: Attributes): Attributes =>
  robottype === undefined ? others : { ...others, robottype: robots.includes(robottype) ? robottype : 'ev3' }

const set = (stacks: readonly Stack[], attributes: Attributes = fresh) =>
  element('block_set', forRobot(attributes), stacks.map(instance).join('')) + '\n'

const instance = ({ x, y, blocks }: Stack) =>
  '\n' + element('instance', { x: String(x), y: String(y) }, rowOf(blocks))

const rowOf = (blocks: readonly Block[]) => blocks.map((block) => writeBlock(block, 'block')).join('')

/** A shadow is one in an input alone; in a row it is a block that calls itself one. */
function writeBlock(block: Block, name = isShadow(block) ? 'shadow' : 'block'): string {
  const inputs = [...valuesOf(block), ...statementsOf(block)]
  const wrapped = isWrapped(block)
  const parts = [
    mutationOf(block),
    ...entriesByName(block.fields ?? {}).map(([field, text]) =>
      element('field', { name: field }, textOf(text)),
    ),
    wrapped
      ? element(
          'repetitions',
          {},
          inBranches(inputs)
            .map(({ xml }) => xml)
            .join(''),
        )
      : '',
    notesOf(block),
    ...(wrapped ? [] : inputs.map(({ xml }) => xml)),
  ]
  return element(name, attributesOf(block, name), parts.join(''))
}

/** A shadow has at most one field in a file, and nothing else. */
const isShadow = ({ shadow, fields = {}, flags = {}, ...rest }: Block) =>
  shadow === true &&
  flags['shadow'] !== 'true' &&
  Object.keys(fields).length <= 1 &&
  !(rest.mutation || rest.values || rest.statements)

function attributesOf(block: Block, name: string) {
  const { id, type, inline, collapsed, disabled, shadow, flags = {} } = block
  const { id: ownId = id, ...others } = Object.fromEntries(
    Object.entries(flags).filter(([name]) => !isNote(name)),
  )
  const states = Object.entries({
    inline,
    collapsed,
    disabled,
    shadow: shadow && name === 'block' ? true : undefined,
  })
  return {
    ...others,
    ...{ type, id: ownId },
    ...Object.fromEntries(states.flatMap(([name, on]) => (on === undefined ? [] : [[name, String(on)]]))),
  }
}

/** Flags that are no attributes of the block: `comment.w`, `error`, `hide.NAME` … */
const isNote = (name: string) =>
  name === flag || notes.includes(name) || /^(comment|error|warning|hide|under)\./.test(name)
const notes = ['error', 'warning']

function mutationOf({ mutation }: Block): string {
  if (!mutation) return ''
  const args = mutation.args?.map(({ name, type }) => element('arg', { name, type })) ?? []
  return element('mutation', mutation.attrs, args.join(''))
}

function notesOf({ comment, data, hide = [], flags = {} }: Block): string {
  const note = (name: string, text: string | undefined) =>
    text === undefined ? '' : element(name, attributesIn(flags, `${name}.`), textOf(text))
  return [
    note('comment', comment),
    ...notes.map((name) => note(name, flags[name])),
    data === undefined ? '' : element('data', {}, textOf(data)),
    ...hide
      .filter((name) => !isReserved(name))
      .map((name) => element('hide', { name, value: flags[`hide.${name}`] ?? '' })),
  ].join('')
}

const attributesIn = (flags: { readonly [name: string]: string }, prefix: string) => ({
  ...(prefix === 'comment.' && { w: '160', h: '80', pinned: 'false' }),
  ...Object.fromEntries(
    Object.entries(flags).flatMap(([name, value]) =>
      name.startsWith(prefix) ? [[name.slice(prefix.length), value]] : [],
    ),
  ),
})

const valuesOf = ({ values = {}, flags = {} }: Block) =>
  entriesByName(values).map(([name, block]) => {
    const lies = block.shadow === true || block.flags?.['shadow'] === 'true'
    const shadow = lies ? '' : underneath(flags[`under.${name}`])
    return { kind: 'value' as const, name, xml: element('value', { name }, shadow + writeBlock(block)) }
  })

/** The shadow that lies under a plugged-in block. What a stranger's project says here is not trusted. */
function underneath(text: string | undefined): string {
  if (text === undefined) return ''
  try {
    const { success, output } = v.safeParse(blockSchema, JSON.parse(text))
    return success && isShadow(output) ? writeBlock(output) : ''
  } catch {
    return ''
  }
}

const statementsOf = ({ statements = {} }: Block) =>
  entriesByName(statements).map(([name, rows]) => ({
    ...{ kind: 'statement' as const, name },
    xml: element('statement', { name }, rowOf(rows)),
  }))
