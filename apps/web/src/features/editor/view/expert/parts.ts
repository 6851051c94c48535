import * as Blockly from 'blockly/core'
import { entryOf, isKind, listOf, type InputLook, type ValueType, type When } from '@botgarten/blocks'
import { isBotBlock, type BotBlock, type Extra } from '../../model/bot-block.ts'
import { ButtonField } from '../button-field.ts'
import { grouped } from '../../model/list.ts'
import { anchorOf, type ComingParts, type Language } from '../shape.ts'
import { NameField } from './name-field.ts'

const adder = 'WAYS'
const attributesOf = (block: BotBlock) => block.extra.attributes ?? {}

function holds(block: BotBlock, when: When): boolean {
  if ('attribute' in when) return when.is.includes(attributesOf(block)[when.attribute] ?? '')
  return when.is.includes(String(block.getFieldValue(when.field)))
}

// ---- types

/** The type that a field or an attribute of the block names; null where only what is plugged in can tell. */
function typeOf(block: BotBlock): ValueType | null {
  const { typed } = block.definition.look
  if (!typed || 'input' in typed.by) return null
  const { by } = typed
  const said = 'field' in by ? String(block.getFieldValue(by.field)) : attributesOf(block)[by.attribute]
  return said !== undefined && isKind(said) ? said : null
}

/** What a block of a chosen type gives; null where its look says it plainly. */
export function typedOutput(block: BotBlock): string | null {
  const { typed } = block.definition.look
  if (!typed?.output) return null
  const type = typeOf(block)
  if (type === null) return 'any'
  return typed.output === 'list' ? listOf(type) : type
}

function checkOf(block: BotBlock, { name, ...input }: InputLook): string[] | null {
  if (input.kind === 'statements') return input.holds ? [input.holds] : null
  const how = block.definition.look.typed?.inputs?.[name]
  if (!how) return input.accepts.length > 0 ? [...input.accepts] : null
  const type = typeOf(block)
  return type === null
    ? null
    : [how === 'list' ? listOf(type) : entryOf(type) === type || how === 'type' ? type : type]
}

function matchChecks(block: BotBlock) {
  for (const input of block.definition.look.inputs) {
    const there = block.getInput(input.name)
    if (there) there.setCheck(checkOf(block, input))
  }
  const { typed, items } = block.definition.look
  const type = items && typed?.items ? typeOf(block) : null
  if (type !== null)
    for (const name of [...(block.extra.lines ?? []), 'FOOT']) block.getInput(name)?.setCheck([type])
}

// ---- parts that are there only sometimes

/** Variables and parameters are always welcome; other parts follow their field. */
const isThere = (block: BotBlock, input: InputLook): boolean =>
  !input.when || (input.kind === 'statements' && input.holds !== undefined) || holds(block, input.when)

function matchParts(block: BotBlock, language: Language) {
  for (const input of block.definition.look.inputs) {
    if (!input.when) continue
    const there = block.getInput(input.name) !== null
    if (there && !isThere(block, input)) block.removeInput(input.name)
    // A field may change while the block is still being built: the rest of it comes.
    if (!there && isThere(block, input) && block.getInput(anchorOf(input.name)))
      append(block, input, language)
  }
}

function append(block: BotBlock, input: InputLook, { words }: Language) {
  const { name, kind } = input
  if (kind === 'value') block.appendValueInput(name)
  else {
    const mouth = block.appendStatementInput(name)
    // It is empty in most programs: only a label can name the blocks that go in.
    if (input.holds) mouth.appendField(new Blockly.FieldLabel(words(`more.${input.holds}`)))
  }
  const anchor = block.inputList.findIndex((input) => input.name === anchorOf(name))
  const after = block.inputList[anchor + 1]
  if (after && after.name !== name) moveBefore(block, name, after)
}

/** Inputs without a name can be moved to by their place alone. */
function moveBefore(block: BotBlock, name: string, target: Blockly.Input) {
  const from = block.inputList.findIndex((input) => input.name === name)
  block.moveNumberedInputBefore(from, block.inputList.indexOf(target))
}

// ---- more ways

const countOf = (block: BotBlock): number => {
  const { branches } = block.definition.look
  return branches ? Math.min(Number(attributesOf(block)[branches.attribute]) || 0, branches.most) : 0
}

function matchWays(block: BotBlock, { words }: Language) {
  const { branches } = block.definition.look
  if (!branches) return
  const count = countOf(block)
  for (let k = 1; k <= count; k++) if (!block.getInput(`${branches.value}${k}`)) appendWay(block, k, words)
  for (let k = count + 1; block.getInput(`${branches.value}${k}`); k++) {
    block.removeInput(`${branches.value}${k}`)
    block.removeInput(`DO${k}`)
  }
  const minus = block.getInput('FEWER')
  if (minus) minus.setVisible(count > 0)
}

function appendWay(block: BotBlock, k: number, words: Language['words']) {
  const { branches } = block.definition.look
  if (!branches) return
  const label = words(branches.value === 'IF' ? 'more.elseIf' : 'more.orUntil')
  const check = block.appendValueInput(`${branches.value}${k}`).setCheck(['Boolean'])
  check.appendField(new Blockly.FieldLabel(label))
  block.appendStatementInput(`DO${k}`)
  const target = block.getInput(adder)
  if (!target) return
  moveBefore(block, `${branches.value}${k}`, target)
  moveBefore(block, `DO${k}`, target)
}

/** A plus and a minus for ways, before what stands for "else". */
function buildWays(block: BotBlock, { words }: Language) {
  const { branches, inputs } = block.definition.look
  if (!branches) return
  const more = new ButtonField('plus', words('more.addWay'), () => setWays(block, countOf(block) + 1))
  const fewer = new ButtonField('minus', words('more.removeWay'), () => setWays(block, countOf(block) - 1))
  block.appendDummyInput(adder).appendField(more, 'PLUS')
  block.appendEndRowInput('FEWER').appendField(fewer, 'MINUS')
  const otherwise = inputs.some(({ name }) => name === 'ELSE') && elseRow(block)
  if (otherwise) for (const name of [adder, 'FEWER']) moveBefore(block, name, otherwise)
}

/** The row that says "else": what stands before the input itself. */
function elseRow(block: BotBlock): Blockly.Input | undefined {
  const at = block.inputList.findIndex(({ name }) => name === 'ELSE')
  return block.inputList[at - 1]
}

function setWays(block: BotBlock, count: number) {
  const { branches } = block.definition.look
  if (!branches || count < 0 || count > branches.most) return
  const { [branches.attribute]: _before, ...others } = attributesOf(block)
  const attributes = count === 0 ? others : { ...others, [branches.attribute]: String(count) }
  grouped(() => reshape(block, { ...block.extra, attributes }))
}

function reshape(block: BotBlock, extra: Extra) {
  const before = JSON.stringify(block.saveExtraState?.())
  block.loadExtraState?.(extra)
  const after = JSON.stringify(block.saveExtraState?.())
  const Change = Blockly.Events.get(Blockly.Events.BLOCK_CHANGE)
  Blockly.Events.fire(new Change(block, 'mutation', null, before, after))
}

// ---- calls

function matchCall(block: BotBlock) {
  const { look } = block.definition
  if (!look.args) return
  const name = attributesOf(block)['name'] ?? ''
  const label = block.getField('CALLED')
  if (label) label.setValue(name)
  else block.inputList[0]?.appendField(new Blockly.FieldLabel(name), 'CALLED')
  ;(block.extra.rest?.args ?? []).forEach(({ name: parameter, type }, k) => {
    if (block.getInput(`ARG${k}`)) return
    const input = block.appendValueInput(`ARG${k}`).setCheck(isKind(type) ? [type] : null)
    input.appendField(new Blockly.FieldLabel(parameter))
  })
}

// ---- shape

/** A block that gives a value or stands in a row, as its field says. */
function matchShape(block: BotBlock) {
  const { also } = block.definition.look
  if (!also) return
  const isRow = holds(block, also.when)
  if (isRow === (block.outputConnection === null)) return
  block.unplug(true)
  if (isRow) {
    block.setOutput(false)
    block.setPreviousStatement(true)
    block.setNextStatement(true)
  } else {
    block.setPreviousStatement(false)
    block.setNextStatement(false)
    block.setOutput(true)
  }
}

/** Declarations hang only where the program or a function keeps them. */
function matchDeclaration(block: BotBlock) {
  const kind = declarations[block.type]
  if (kind === undefined) return
  block.setPreviousStatement(true, kind)
  block.setNextStatement(true, kind)
}

const declarations: { readonly [type: string]: string } = {
  robGlobalVariables_declare: 'variables',
  robLocalVariables_declare: 'parameters',
}

function match(block: BotBlock, language: Language) {
  matchShape(block)
  matchParts(block, language)
  matchWays(block, language)
  matchCall(block)
  matchChecks(block)
  if (block.outputConnection && block.definition.look.typed?.output) {
    const output = typedOutput(block)
    block.outputConnection.setCheck(output === 'any' ? null : output)
  }
}

export const comingParts: ComingParts = {
  build(block, language) {
    buildWays(block, language)
    matchDeclaration(block)
    match(block, language)
  },
  match: (block, language) => void (isBotBlock(block) && match(block, language)),
  nameField: (look, block) => new NameField(look, block),
}
