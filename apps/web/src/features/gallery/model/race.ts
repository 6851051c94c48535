import type { Document } from '@botgarten/lab'
import { withWeights } from '@botgarten/learning/neural-network'
import { most, type Project } from '@botgarten/programs'
import { withGuest, withRobot } from '#lab/robots.ts'
import { brainOf, fitted } from './brain.ts'

/**
 * The own project with another child's robot beside its first one. Where the brain fits the own network it drives with
 * that alone, and the knobs can be compared; else it brings its program along.
 * @param title name of the weights
 * @returns null where there is no room for another robot
 */
export function besideMine(mine: Project, theirs: Project, title: string): Project | null {
  if (mine.world.robots.length >= most.robots) return null
  return withTheirBrain(mine, theirs, title) ?? withTheirRobot(mine, theirs)
}

function withTheirBrain(mine: Project, theirs: Project, title: string): Project | null {
  const [own, other] = [brainOf(mine), brainOf(theirs)]
  const fit = own && other && fitted(other, own)
  if (!own || !fit) return null
  const first = mine.world.robots[0]!
  const { id, document } = withRobot(mine, first.id, 'shared')
  const set = isFree(document, title) ? title : id
  const brain = withWeights(document.brains[own.net.id] ?? fit.brain, fit.weights, set)
  const robots = document.world.robots.map((robot) => (robot.id === id ? { ...robot, brain: set } : robot))
  const brains = { ...document.brains, [own.net.id]: brain }
  return { ...mine, ...document, brains, world: { ...document.world, robots } }
}

const isFree = ({ brains, world }: Document, name: string) =>
  name.length <= 40 &&
  !['__proto__', 'constructor', 'prototype'].includes(name) &&
  !world.robots.some(({ id }) => id === name) &&
  !Object.values(brains).some(({ sets }) => Object.hasOwn(sets, name))

/** With their program, weights and sensors. */
function withTheirRobot(mine: Project, theirs: Project): Project | null {
  const { world, ...grown } = withGuest(mine, theirs)?.document ?? {}
  return world ? { ...mine, ...grown, world: { ...mine.world, robots: world.robots } } : null
}
