import { writeFileSync } from 'node:fs'
import { extname } from 'node:path'
import { isBlockType, type Block } from '@botgarten/blocks'
import { writeProject, type Project } from '@botgarten/programs'
import { fileFrom } from '@botgarten/programs/open-roberta'
import { CallError, FileError, options } from './errors.ts'
import { isOpenRoberta, readProjectFile } from './project-file.ts'

const known = { robot: { type: 'string' }, json: { type: 'boolean' } } as const

/** `botgarten convert IN OUT`: a project or an Open Roberta file as the other of them, by the files' endings. */
export function convert(args: string[]): string {
  const { values, positionals } = options(args, known)
  const [from, to, ...more] = positionals
  if (!from || !to || more.length > 0) throw new CallError('"convert" takes two files: IN and OUT.')
  for (const path of [from, to])
    if (!['.xml', '.json'].includes(extname(path).toLowerCase()))
      throw new CallError(`"${path}" ends neither in .xml nor in .json.`)
  const project = readProjectFile(from)
  const robot = robotOf(project, values.robot)
  write(to, isOpenRoberta(to) ? fileFrom(project, robot.id) : writeProject(project))
  const blocks = project.programs[robot.program]!.stacks.flatMap((stack) => stack.blocks.flatMap(typesIn))
  const unknown = [...new Set(blocks.filter((type) => !isBlockType(type)))].sort()
  return values.json
    ? JSON.stringify({ in: from, out: to, robot: robot.id, blocks: blocks.length, unknown })
    : `${to}: ${blocks.length} blocks${unknown.length > 0 ? `; kept without being known here: ${unknown.join(', ')}` : ''}`
}

function robotOf({ world }: Project, id: string | undefined) {
  const robot = id === undefined ? world.robots[0] : world.robots.find((one) => one.id === id)
  if (!robot)
    throw new CallError(`There is no robot "${id}": ${world.robots.map((one) => one.id).join(', ')}.`)
  return robot
}

function write(path: string, text: string): void {
  try {
    writeFileSync(path, text)
  } catch (error) {
    throw new FileError(`"${path}" cannot be written: ${(error as Error).message}`)
  }
}

const typesIn = ({ type, values, statements }: Block): string[] => [
  type,
  ...[...Object.values(values ?? {}), ...Object.values(statements ?? {}).flat()].flatMap(typesIn),
]
