import senses from 'content:senses'
import worlds from 'content:worlds'
import { pictureIn } from '#lab/floor/pictures.ts'
import { SenseWork } from './sense-work.svelte.ts'

/** A cage with its world, ready to be looked at; null where there is no such cage. */
export async function openSenseCage(id: string): Promise<SenseWork | null> {
  const found = senses.senseCages.find(({ cage }) => cage.id === id)
  const world = found && (await worlds.world(found.cage.world))
  if (!found || !world) return null
  const [robot] = world.robots
  const at = found.cage.starts.map((pose) => ({ ...world, robots: [{ ...robot!, pose }] }))
  const looks = found.cage.trial.sensors.some(({ mode }) => mode !== 'distance' && mode !== 'touch')
  return new SenseWork(found, { worlds: at, picture: looks ? await pictureIn(world, undefined) : null })
}
