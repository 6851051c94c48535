import { existsSync } from 'node:fs'
import { cardProject } from '@botgarten/content'
import type { LoadedCard } from '@botgarten/content/catalogue'
import { content } from '@botgarten/content/files'
import { brainsFor } from '@botgarten/lab'
import type { Brain } from '@botgarten/learning/neural-network'
import type { Block } from '@botgarten/blocks'
import { networks, type NetworkOutline, type Program, type Project } from '@botgarten/programs'
import type { RobotConfig } from '@botgarten/simulation'
import { CallError, FileError } from '../errors.ts'
import { readProjectFile } from '../project-file.ts'

/** A project with one of its networks, and the card that it belongs to. */
export interface Source {
  readonly project: Project
  readonly card: LoadedCard | null
  /** Key of the network's program. */
  readonly program: string
  readonly network: NetworkOutline
  readonly brain: Brain
  readonly config: RobotConfig
}

interface Asked {
  readonly solution?: boolean | undefined
  /** Id of the network's block; the first where none is named. */
  readonly brain?: string | undefined
}

/** What a call names: a card by its name, or the file of a project. */
export function projectOf(what: string, solution = false): Pick<Source, 'project' | 'card'> {
  const found = content.card(what)
  if (found) {
    const program = content.program(found.card.id, solution ? 'solution' : 'start')!
    return { project: cardProject(found.world, found.card, program, what), card: found }
  }
  if (!existsSync(what)) throw new CallError('call.noCardNoFile', { name: what })
  if (solution) throw new CallError('call.ofACard')
  const project = readProjectFile(what)
  return { project, card: project.card === undefined ? null : content.card(project.card) }
}

export function sourceOf(what: string, { solution, brain }: Asked): Source {
  const { project, card } = projectOf(what, solution)
  return { ...networkIn(project, brain), card }
}

/** A network of a project as its blocks say it. */
export function networkIn(project: Project, id: string | undefined): Omit<Source, 'card'> {
  const all = Object.entries(project.programs).flatMap(([program, blocks]) =>
    networks(blocks).map((network) => ({ program, network })),
  )
  const found = id === undefined ? all[0] : all.find(({ network }) => network.id === id)
  if (!found && id !== undefined && all.length > 0)
    throw new CallError('call.noBrain', { id, known: all.map(({ network }) => network.id).join(', ') })
  if (!found) throw new FileError('weights.noNetwork')
  const brain = brainsFor(project.programs, project.brains)[found.network.id]!
  const robots = project.world.robots
  const robot = robots.find(({ program }) => program === found.program) ?? robots[0]
  if (!robot) throw new FileError('file.noRobot')
  return { project, ...found, brain, config: robot.config }
}

/** A block of a program by its id, with all that is in it. */
export function blockIn({ stacks }: Program, id: string): Block | undefined {
  const found = (block: Block): Block | undefined => {
    if (block.id === id) return block
    const inside = [...Object.values(block.values ?? {}), ...Object.values(block.statements ?? {}).flat()]
    return first(inside, found)
  }
  return first(
    stacks.flatMap(({ blocks }) => blocks),
    found,
  )
}

function first<One>(all: readonly One[], found: (one: One) => One | undefined): One | undefined {
  for (const one of all) {
    const result = found(one)
    if (result) return result
  }
  return undefined
}
