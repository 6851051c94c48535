import { extname } from 'node:path'
import { isBlockType, type Block } from '@botgarten/blocks'
import { writeProjectFile, type Project } from '@botgarten/programs'
import { fileFrom } from '@botgarten/programs/open-roberta'
import { dialects } from '@botgarten/programs/python'
import type { Command } from './commands.ts'
import { CallError } from './errors.ts'
import { write } from './files.ts'
import { oneOf, options } from './options.ts'
import { isOpenRoberta, readProjectFile } from './project-file.ts'
import { pythonOf } from './python.ts'
import { message } from './words.ts'

const known = {
  robot: { type: 'string' },
  dialect: { type: 'string' },
  'no-errors': { type: 'boolean' },
  learner: { type: 'boolean' },
  json: { type: 'boolean' },
} as const

/** `botgarten convert IN OUT`: a project or an Open Roberta file as the other of them, or as Python, by the files' endings. */
export const convert: Command = { options: known, execute: convertFile }

function convertFile(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [from, to, ...more] = positionals
  if (!from || !to || more.length > 0) throw new CallError('call.convertWhat')
  refuseEndings(from, to)
  const how = {
    dialect: oneOf('dialect', values.dialect, dialects),
    ...{ gaps: !values['no-errors'], learner: values.learner === true },
  }
  const project = readProjectFile(from)
  const robot = robotOf(project, values.robot)
  write(to, isPython(to) ? pythonOf(project, robot, how) : textOf(to, project, robot.id))
  const blocks = project.programs[robot.program]!.stacks.flatMap((stack) => stack.blocks.flatMap(typesIn))
  const unknown = [...new Set(blocks.filter((type) => !isBlockType(type)))].sort()
  return values.json
    ? JSON.stringify({ in: from, out: to, robot: robot.id, blocks: blocks.length, unknown })
    : sentenceOf(to, blocks.length, unknown)
}

const isPython = (path: string) => extname(path).toLowerCase() === '.py'

/** Python is not read back into blocks. */
function refuseEndings(from: string, to: string): void {
  if (isPython(from)) throw new CallError('call.fromPython', { path: from })
  for (const path of [from, to])
    if (!['.xml', '.json', '.py'].includes(extname(path).toLowerCase()))
      throw new CallError('call.ending', { path })
}

const textOf = (path: string, project: Project, robot: string) =>
  isOpenRoberta(path) ? fileFrom(project, robot) : writeProjectFile(project)

function sentenceOf(path: string, count: number, unknown: readonly string[]): string {
  const blocks = message('converted.blocks', { path, count })
  return unknown.length === 0 ? blocks : message('converted.unknown', { blocks, types: unknown.join(', ') })
}

function robotOf({ world }: Project, id: string | undefined) {
  const robot = id === undefined ? world.robots[0] : world.robots.find((one) => one.id === id)
  if (!robot)
    throw new CallError('call.noRobot', {
      id: id ?? '',
      robots: world.robots.map((one) => one.id).join(', '),
    })
  return robot
}

const typesIn = ({ type, values, statements }: Block): string[] => [
  type,
  ...[...Object.values(values ?? {}), ...Object.values(statements ?? {}).flat()].flatMap(typesIn),
]
