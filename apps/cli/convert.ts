import { extname } from 'node:path'
import { isBlockType, type Block } from '@botgarten/blocks'
import { writeProjectFile, type Project } from '@botgarten/programs'
import { fileFrom } from '@botgarten/programs/open-roberta'
import type { Command } from './commands.ts'
import { CallError } from './errors.ts'
import { write } from './files.ts'
import { options } from './options.ts'
import { isOpenRoberta, readProjectFile } from './project-file.ts'
import { message } from './words.ts'

const known = { robot: { type: 'string' }, json: { type: 'boolean' } } as const

/** `botgarten convert IN OUT`: a project or an Open Roberta file as the other of them, by the files' endings. */
export const convert: Command = { options: known, execute: convertFile }

function convertFile(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [from, to, ...more] = positionals
  if (!from || !to || more.length > 0) throw new CallError('call.convertWhat')
  for (const path of [from, to])
    if (!['.xml', '.json'].includes(extname(path).toLowerCase())) throw new CallError('call.ending', { path })
  const project = readProjectFile(from)
  const robot = robotOf(project, values.robot)
  write(to, isOpenRoberta(to) ? fileFrom(project, robot.id) : writeProjectFile(project))
  const blocks = project.programs[robot.program]!.stacks.flatMap((stack) => stack.blocks.flatMap(typesIn))
  const unknown = [...new Set(blocks.filter((type) => !isBlockType(type)))].sort()
  return values.json
    ? JSON.stringify({ in: from, out: to, robot: robot.id, blocks: blocks.length, unknown })
    : sentenceOf(to, blocks.length, unknown)
}

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
