import { definitions, isBlockType, type Block } from '@botgarten/blocks'
import { within } from '../check/names.ts'
import { isEndless } from '../check/reached.ts'
import { declaredIn } from '../run/index-program.ts'
import { assembled } from './assemble.ts'
import { Draft } from './draft.ts'
import { learnedLines } from './learned.ts'
import { lessonLines } from './lesson.ts'
import { ev3dev2Robot } from './robots/ev3dev2.ts'
import { pybricksRobot } from './robots/pybricks.ts'
import type { Line, PythonFile, PythonInput, Say } from './types.ts'
import { assignedIn, Usage } from './usage.ts'
import { Writer } from './writer.ts'

export { dialects } from './types.ts'
export type { Dialect, Learned, Lesson, PythonFile, PythonInput, PythonNote, Say } from './types.ts'
export { centresIn } from './centres.ts'
export { fileName } from './file-name.ts'

const robots = { pybricks: pybricksRobot, ev3dev2: ev3dev2Robot, spike: pybricksRobot }

/**
 * A program as Python for a real robot. What its brick cannot do stands in it as a comment, what is not finished as
 * `raise NotImplementedError`. `say` words comments in the child's language.
 */
export function pythonFrom(input: PythonInput, say: Say): PythonFile {
  const draft = new Draft(input, say)
  const usage = new Usage(input.program)
  nameEverything(draft, usage)
  const writer = new Writer(draft, usage, robots[input.dialect](draft))
  learnedLines(draft, usage)
  lessonLines(draft, usage)
  const functions = usage.functions.map((block) => functionOf(writer, block))
  usage.inMain()
  const made = section(draft, () => {
    writer.rows(usage.start?.statements?.ST)
    sortingLines(draft, usage)
  })
  const main = section(draft, () => mainLines(writer))
  return assembled(draft, { functions, made, main })
}

/** The child's names come first: what the file brings along makes way. */
function nameEverything({ names }: Draft, { functions, program }: Usage): void {
  for (const block of functions) {
    const name = block.fields?.NAME ?? ''
    names.of(`function ${name}`, name)
  }
  for (const { fields } of program.stacks.flatMap(({ blocks }) => blocks.flatMap(inOrder)))
    if (fields?.VAR !== undefined) names.of(`variable ${fields.VAR}`, fields.VAR)
}

/** A block with all that is in it, as it is read. */
const inOrder = (block: Block): readonly Block[] => [
  block,
  ...[...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()].flatMap(inOrder),
]

function section(draft: Draft, write: () => void): readonly Line[] {
  draft.lines = []
  draft.pending = new Set()
  write()
  return draft.lines
}

function mainLines(writer: Writer): void {
  const { draft, usage } = writer
  if (!usage.start) return draft.comment(draft.gap('', 'problem.noStart'))
  if (usage.start.comment) draft.comment(usage.start.comment)
  writer.rows(usage.main)
  draft.pending = new Set()
  if (!usage.main.some(isEndless)) endLines(draft)
}

/** On ev3dev motors go on turning when a program is over. */
function endLines(draft: Draft): void {
  if (draft.input.dialect !== 'ev3dev2') return
  for (const [key, { name }] of draft.devices)
    if (key === 'base' || key.startsWith('motor ')) draft.line(`${name}.off()`)
}

function functionOf(writer: Writer, block: Block): readonly Line[] {
  const { draft, usage } = writer
  usage.inside(block)
  const parameters = declaredIn(block.statements?.ST).map(({ fields }) => fields?.VAR ?? '')
  const name = draft.names.of(`function ${block.fields?.NAME ?? ''}`, '')
  const variables = parameters.map((one) => draft.names.of(`variable ${one}`, one))
  return section(draft, () => {
    draft.pending = new Set([block.id])
    if (block.comment) draft.comment(block.comment)
    draft.line(`def ${name}(${variables.join(', ')}):`)
    writer.inner(() => {
      globalLine(draft, usage, block, parameters)
      writer.rows(block.statements?.STACK, true)
      if (block.type === 'robProcedures_defreturn') writer.result(block)
    })
  })
}

/** Variables of the program that a function gives values to. */
function globalLine(draft: Draft, { globals }: Usage, block: Block, parameters: readonly string[]): void {
  const local = within(block).flatMap(({ type, fields }) =>
    /^robControls_for/.test(type) ? [fields?.VAR] : [],
  )
  const given = new Set(assignedIn([block]))
  const names = globals.filter(
    (name) => given.has(name) && !parameters.includes(name) && !local.includes(name),
  )
  if (names.length > 0)
    draft.line(`global ${names.map((name) => draft.names.of(`variable ${name}`, name)).join(', ')}`)
}

const sorts = (block: Block) => isBlockType(block.type) && definitions[block.type].look.category === 'sorting'

/** What the blocks of sorting remember: it is there before the first of them. */
function sortingLines(draft: Draft, { program }: Usage): void {
  const all = program.stacks.flatMap(({ blocks }) => blocks.flatMap(within))
  if (!all.some(sorts)) return
  const { centres = [] } = draft.input.learned ?? {}
  const rows = centres.map((centre) => `[${centre.map((part) => Math.round(part)).join(', ')}]`)
  draft.line(`${draft.names.of('sorting readings', 'readings')} = []`)
  draft.line(`${draft.names.of('sorting centres', 'centres')} = [${rows.join(', ')}]`)
  draft.line(`${draft.names.of('sorting names', 'names')} = {}`)
}
