import { diff, type Shared } from '@botgarten/programs/together'
import { inScene, sceneOf, type Project } from '@botgarten/programs'
import type { Floor } from '@botgarten/simulation'
import type { LabSession } from '#lab/session.svelte.ts'

const same = (a: unknown, b: unknown) => a === b || JSON.stringify(a) === JSON.stringify(b)

export const sharedOf = ({ programs, brains, world }: Shared | Project): Shared => ({
  programs,
  brains,
  world,
})

/** On an own photo: it goes to no other child. */
export const isOnPhoto = ({ world: { floor } }: Shared): boolean =>
  'asset' in floor && !floor.asset.startsWith('content:')

/** Is the floor painted otherwise than here? Its picture comes later than its name. */
export const hasOtherFloor = (session: LabSession, { world }: Shared): boolean =>
  !same(sceneOf(session.lab.document.world), sceneOf(world))

/** What is not shown now: a moment of the past is looked at, or a run is on that other blocks would begin again. */
type Waiting = 'all' | 'blocks' | null

export function waitingIn({ lab: { facts } }: LabSession): Waiting {
  if (facts.past) return 'all'
  return facts.phase === 'running' || facts.phase === 'paused' ? 'blocks' : null
}

/**
 * Makes a project what the two have made of it; only what differs is touched.
 * @param floor of that world, where it is another one
 * @returns whether something of it waits
 */
export function show(session: LabSession, shared: Shared, waiting: Waiting, floor: Floor | null): boolean {
  if (waiting === null) {
    showScene(session, shared, floor)
    showRobots(session, shared)
    showPrograms(session, shared)
  }
  if (waiting !== 'all') showBrains(session, shared, waiting)
  return waiting !== null && diff(sharedOf(session.project), shared).length > 0
}

function showScene(session: LabSession, shared: Shared, floor: Floor | null): void {
  if (!hasOtherFloor(session, shared)) return
  const { paint } = session
  if (floor) session.paint = () => floor
  session.apply({ kind: 'scene', after: sceneOf(shared.world) }, 'silent')
  session.paint = paint
}

const whoDrives = ({ programs, world }: Shared) => [
  Object.keys(programs).toSorted(),
  world.robots.map(({ id, program }) => [id, program]),
]

function showRobots(session: LabSession, { programs, brains, world }: Shared): void {
  const now = session.lab.document
  if (same(whoDrives(now), whoDrives({ programs, brains, world })) && same(now.world.robots, world.robots))
    return
  const after = { ...now, programs, brains, world: inScene(world, sceneOf(now.world)) }
  session.apply({ kind: 'robots', after }, 'silent')
}

function showPrograms(session: LabSession, { programs }: Shared): void {
  for (const [program, after] of Object.entries(programs))
    if (!same(session.lab.document.programs[program], after))
      session.apply({ kind: 'program', program, after }, 'silent')
}

/** Knobs turn while it drives; layers come with their blocks. */
function showBrains(session: LabSession, { brains }: Shared, waiting: Waiting): void {
  for (const [id, after] of Object.entries(brains)) {
    const now = session.lab.document.brains[id]
    const fits = waiting === null || same(now?.layers, after.layers)
    if (fits && !same(now, after)) session.apply({ kind: 'brain', id, after }, 'silent')
  }
}
