import type { Document } from '@botgarten/lab'
import type { Project } from '@botgarten/programs'
import type { Card, CardProgram, WorldFile } from './schema/cardTypes.ts'

/** The world of a card with its robot on start pose `start` (from 0). @throws RangeError where there is no such pose. */
export function worldAt(world: WorldFile, card: Card, start: number): WorldFile {
  const from = card.starts[start]
  if (!from) throw new RangeError(`${card.id} has start poses 0 to ${card.starts.length - 1}.`)
  return {
    ...world,
    robots: world.robots.map((robot, index) => (index === 0 ? { ...robot, pose: from } : robot)),
  }
}

/** What a lab runs for a card's program on one of its start poses. */
export const cardDocument = (
  world: WorldFile,
  card: Card,
  program: CardProgram,
  start: number,
): Document => ({
  programs: program.programs,
  brains: program.brains,
  ...(program.tables && { tables: program.tables }),
  ...(program.raced && { raced: program.raced }),
  world: worldAt(world, card, start),
})

/** A new project for a card: its start program in its world. */
export const cardProject = (world: WorldFile, card: Card, program: CardProgram, name: string): Project => ({
  botgarten: 1,
  name,
  card: card.id,
  ...cardDocument(world, card, program, 0),
  assets: {},
})
