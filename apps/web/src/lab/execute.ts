import { emptyBrain } from '@botgarten/learning/neural-network/brain'
import { inScene, sceneOf } from '@botgarten/programs'
import type { Change } from './change.ts'
import type { Extras } from './extras.svelte.ts'
import type { CardProgress } from './progress.svelte.ts'
import type { LabSession } from './session.svelte.ts'

/** What only changes write. */
export interface Written {
  readonly extras: Extras
  readonly progress: CardProgress
}

type Of<Kind extends Change['kind']> = Extract<Change, { kind: Kind }>

type Executors = {
  readonly [Kind in Change['kind']]: (
    change: Of<Kind>,
    session: LabSession,
    written: Written,
  ) => Change | null
}

function take(change: Of<'learned' | 'shelf'>, _session: LabSession, { extras }: Written): Change {
  extras.take(change)
  return change
}

const executors: Executors = {
  program(change, { lab, opened }, { progress }) {
    // On a card Bo begins again; a project of one's own goes on from where everything stands (running.md 9).
    lab.edit({ ...lab.document.programs, [change.program]: change.after }, opened.card !== null)
    // Other blocks are another run.
    if (lab.view.tick === 0) progress.begin(lab.view.robots[0]?.pose)
    return change
  },

  blocks(change, session) {
    // They are taken back where they are seen.
    const own = session.lab.document.world.robots.find(({ program }) => program === change.program)
    if (own && session.robot.program !== change.program) session.choose(own.id)
    return session.moveBlocks(change.direction, change.program) ? change : null
  },

  place(change, { lab }, { progress }) {
    progress.helped()
    return { ...change, after: lab.place(change.id, change.after, change.start), start: undefined }
  },

  weight({ network, from, to, after, set }, { lab }) {
    lab.setWeight(network, from, to, after, set)
    return { kind: 'brain', id: network, after: lab.document.brains[network] ?? emptyBrain }
  },

  brain(change, { lab }) {
    lab.setBrain(change.id, change.after)
    return change
  },

  examples(change, { lab }) {
    lab.setTraining(change.network, { examples: change.after ?? null })
    return change
  },

  practice(change, { lab }) {
    lab.setTraining(change.network, { practice: change.after ?? null })
    return change
  },

  table(change, { lab }) {
    const { [change.id]: _, ...others } = lab.document.tables ?? {}
    const tables = change.after ? { ...others, [change.id]: change.after } : others
    lab.rebuild({ ...lab.document, tables })
    return change
  },

  config(change, { lab }) {
    const { document } = lab
    const robot = document.world.robots.find(({ id }) => id === change.id)
    if (!robot || JSON.stringify(robot.config) === JSON.stringify(change.after)) return null
    const robots = document.world.robots.map((one) =>
      one === robot ? { ...one, config: change.after } : one,
    )
    lab.rebuild({ ...document, world: { ...document.world, robots } })
    return change
  },

  scene({ after, pictures, stood }, session, { extras, progress }) {
    extras.addPictures(pictures)
    progress.helped()
    const { lab } = session
    const { document } = lab
    const floor = session.paint(after) ?? undefined
    lab.rebuild({ ...document, world: inScene(document.world, after) }, floor, stood)
    return { kind: 'scene', after: sceneOf(lab.document.world) }
  },

  robots({ after, stood }, { lab }, { progress }) {
    const { robots } = after.world
    progress.helped()
    lab.rebuild({ ...after, world: { ...lab.document.world, robots } }, undefined, stood)
    return { kind: 'robots', after: lab.document }
  },

  future(change, { lab }) {
    lab.swap()
    return change
  },

  progress(change, _session, { progress }) {
    progress.set(change.after)
    return change
  },

  learned: take,
  shelf: take,
}

/** Makes a change happen. Returns it as it came out; null where it did not happen. */
export function execute(change: Change, session: LabSession, written: Written): Change | null {
  const executor = executors[change.kind] as (...given: Parameters<typeof execute>) => Change | null
  return executor(change, session, written)
}
