import * as v from 'valibot'
import { ProjectError } from '../project/error.ts'
import { refuseOversize } from '../project/limits.ts'
import { programSchema } from '../project/schema-program.ts'
import type { Program, Stack } from '../types.ts'
import { readRow, refuseText, type Ids } from './read-block.ts'
import { notOpenRoberta, treeOf, type Element } from './tree.ts'

/** The same brick under two names. */
export const robots: readonly string[] = ['ev3', 'xNN']

/**
 * The program of an Open Roberta file, configuration included (open-roberta-files.md). Blocks that are unknown here are
 * kept like all others. Nothing of the file is trusted.
 * @throws {ProjectError} and nothing else
 */
export function readOpenRoberta(text: string): Program {
  const root = treeOf(text)
  const parts = partsOf(root)
  const program = setIn(parts.program)
  const config = parts.config && setIn(parts.config)
  refuseOtherRobots([program, config])
  return checked({
    stacks: stacksIn(program),
    config: { stacks: config ? stacksIn(config) : [] },
    raw: {
      attributes: program.attributes,
      ...(config && { config: config.attributes }),
      root: root.attributes,
    },
  })
}

function partsOf(root: Element): { readonly program: Element; readonly config: Element | undefined } {
  refuseText(root)
  if (root.name !== 'export') throw notOpenRoberta(`Its root is "${root.name}", not "export".`)
  const [program, config, ...more] = root.children
  const right = program?.name === 'program' && (config === undefined || config.name === 'config')
  if (!right || more.length > 0) throw notOpenRoberta('It holds something else than a program and a config.')
  return { program, config }
}

/** The one `<block_set>` of a part. An empty configuration is none. */
function setIn(part: Element): Element {
  refuseText(part)
  const [set, ...more] = part.children
  if (set?.name !== 'block_set' || more.length > 0) throw notOpenRoberta(`"${part.name}" has no block_set.`)
  refuseText(set)
  return set
}

function refuseOtherRobots(sets: readonly (Element | undefined)[]): void {
  for (const set of sets) {
    const robot = set?.attributes['robottype'] ?? ''
    if (robot !== '' && !robots.includes(robot))
      throw new ProjectError('otherRobot', `This program is for the robot "${robot}".`, {
        robot: robot.slice(0, 40),
      })
  }
}

function stacksIn(set: Element): readonly Stack[] {
  const ids: Ids = new Map()
  return set.children.map((instance) => {
    if (instance.name !== 'instance') throw notOpenRoberta(`"${instance.name}" stands beside the stacks.`)
    return {
      x: placeIn(instance.attributes['x']),
      y: placeIn(instance.attributes['y']),
      blocks: readRow(instance, ids),
    }
  })
}

function placeIn(text = '0'): number {
  const place = Number(text)
  if (!Number.isFinite(place)) throw notOpenRoberta(`A stack lies at "${text}".`)
  return place
}

/** What opens can also be kept: the same limits as for a project's file. */
function checked(program: Program): Program {
  refuseTooMuch(program)
  const result = v.safeParse(programSchema, program, { abortEarly: true })
  if (result.success) return result.output
  const { path, message } = result.issues[0]
  throw notOpenRoberta(`${path?.map(({ key }) => String(key)).join('.') ?? ''}: ${message}`)
}

/** As part of a project, which is how it will be saved. */
function refuseTooMuch(program: Program): void {
  try {
    refuseOversize({ programs: { main: program } })
  } catch (error) {
    if (!(error instanceof ProjectError) || error.reason === 'tooBig') throw error
    throw new ProjectError('tooDeep', 'It is nested too deeply.')
  }
}
