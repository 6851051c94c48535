import * as v from 'valibot'
import type { Block } from '@botgarten/blocks'
import { blockSchema } from '../project/schema-program.ts'
import type { Program, Stack } from '../types.ts'
import { flag, inBranches, isWrapped } from './repetitions.ts'
import { element, textOf } from './xml.ts'

const xmlns = 'http://de.fhg.iais.roberta.blockly'
const fresh = { xmlns, robottype: 'ev3', xmlversion: '3.1', description: '', tags: '' }

/** An Open Roberta file with the program and its configuration; read again, it is the same program. */
export function writeOpenRoberta({ stacks, config, raw }: Program): string {
  const program = element('program', {}, set(stacks, raw?.attributes))
  const setUp =
    raw && !raw.config && config.stacks.length === 0 ? '' : set(config.stacks, raw?.config ?? raw?.attributes)
  return element('export', raw?.root ?? { xmlns }, program + (setUp && element('config', {}, setUp)))
}

const set = (stacks: readonly Stack[], attributes: { readonly [name: string]: string } = fresh) =>
  element('block_set', attributes, stacks.map(instance).join('')) + '\n'

const instance = ({ x, y, blocks }: Stack) =>
  '\n' + element('instance', { x: String(x), y: String(y) }, rowOf(blocks))

const rowOf = (blocks: readonly Block[]) => blocks.map((block) => writeBlock(block)).join('')

function writeBlock(block: Block): string {
  const name = isShadow(block) ? 'shadow' : 'block'
  const inputs = [...valuesOf(block), ...statementsOf(block)]
  const wrapped = isWrapped(block)
  const parts = [
    mutationOf(block),
    ...Object.entries(block.fields ?? {}).map(([field, text]) =>
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
  return element(name, attributesOf(block), parts.join(''))
}

/** A shadow has at most one field in a file, and nothing else. */
const isShadow = ({ shadow, fields = {}, flags = {}, ...rest }: Block) =>
  shadow === true &&
  flags['shadow'] === undefined &&
  Object.keys(fields).length <= 1 &&
  !(rest.mutation || rest.values || rest.statements)

function attributesOf(block: Block) {
  const { id, type, inline, collapsed, disabled, shadow, flags = {} } = block
  const { id: ownId = id, ...others } = Object.fromEntries(
    Object.entries(flags).filter(([name]) => !isNote(name)),
  )
  const states = Object.entries({
    inline,
    collapsed,
    disabled,
    shadow: shadow && !isShadow(block) ? true : undefined,
  })
  return {
    ...{ type, id: ownId },
    ...Object.fromEntries(states.flatMap(([name, on]) => (on === undefined ? [] : [[name, String(on)]]))),
    ...others,
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
    ...hide.map((name) => element('hide', { name, value: flags[`hide.${name}`] ?? '' })),
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
  Object.entries(values).map(([name, block]) => {
    const shadow = underneath(flags[`under.${name}`])
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
  Object.entries(statements).map(([name, rows]) => ({
    ...{ kind: 'statement' as const, name },
    xml: element('statement', { name }, rowOf(rows)),
  }))
