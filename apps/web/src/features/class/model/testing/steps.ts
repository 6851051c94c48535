// Steps of two devices of a pupil and of the class, in any order.
import fc from 'fast-check'
import { expect } from 'vitest'
import {
  backUp,
  Cable,
  choose,
  headsIn,
  inBins,
  newPupil,
  settle,
  takeOneBack,
  Work,
  type Device,
  type Fate,
  type Pupil,
} from './devices.ts'

export interface Step {
  readonly kind:
    | ('edit' | 'send' | 'crash' | 'fetch' | 'choose' | 'late' | 'throw' | 'sendAll' | 'back')
    | ('backUp' | 'restore')
  readonly device: 0 | 1
  readonly id?: string
  readonly fate?: Fate
  readonly own?: boolean
}

const id = fc.constantFrom('fear', 'friendship')
const device = fc.constantFrom(0, 1)
const fate = fc.constantFrom<Fate>('arrives', 'isLost', 'answerIsLost', 'comesTwice', 'late')
const arrives = fc.constant<Fate>('arrives')
const own = fc.boolean()

const kind = (kind: Step['kind'], more: object = {}, weight = 1) => ({
  weight,
  arbitrary: fc.record({ kind: fc.constant(kind), device, ...more }) as fc.Arbitrary<Step>,
})

const steps = [
  kind('edit', { id }, 4),
  kind('send', { fate }, 4),
  kind('crash'),
  kind('fetch', { fate }),
  kind('choose', { own }),
  kind('late'),
  kind('throw', { id }),
  kind('sendAll'),
  // On one of them only: restored on both, the same work would exist twice.
  kind('back', { device: fc.constant(0) }),
]

export const someSteps = fc.array(fc.oneof(...steps), { maxLength: 25 })

/** The class is put back to an earlier state now and then, and requests arrive more often than not. */
export const stepsWithRestores = fc.array(
  fc.oneof(
    ...steps,
    kind('sendAll', { fate: arrives }, 3),
    kind('fetch', { fate: arrives }, 2),
    kind('backUp', {}, 2),
    kind('restore', {}, 2),
  ),
  { maxLength: 30 },
)

/**
 * Takes the steps with two empty devices, and lets them settle: no work may be lost.
 * @param own whether a child that has to choose takes its own version
 * @returns the pupil, the cable, and the names of the projects in the class
 */
export async function playAndSettle(
  steps: readonly Step[],
  devices: readonly [Device, Device],
  own: boolean,
): Promise<{ readonly pupil: Pupil; readonly cable: Cable; readonly heads: readonly string[] }> {
  const pupil = await newPupil()
  const cable = new Cable(pupil)
  const work = new Work()
  for (const device of devices) await device.clear()
  await play(steps, { devices, cable, work, pupil })
  await settle(devices, cable, own)
  const heads = await headsIn(pupil)
  expect(work.lostWith([...heads, ...(await inBins(devices))])).toEqual([])
  return { pupil, cable, heads }
}

/** Takes the steps one after the other. */
async function play(
  steps: readonly Step[],
  {
    devices,
    cable,
    work,
    pupil,
  }: {
    readonly devices: readonly [Device, Device]
    readonly cable: Cable
    readonly work: Work
    readonly pupil: Pupil
  },
): Promise<void> {
  let putBack = await backUp(pupil)
  for (const { kind, device, id = 'fear', fate = 'arrives', own = true } of steps) {
    const on = devices[device]
    cable.fate = fate
    if (kind === 'edit') await work.edit(on, id)
    else if (kind === 'send') await on.page.sendNext(cable.ask)
    else if (kind === 'crash') await on.crash()
    else if (kind === 'fetch') await on.page.fetchWork(cable.ask)
    else if (kind === 'throw') await on.page.throwAway(id)
    else if (kind === 'sendAll') await on.page.sendAll(cable.ask)
    else if (kind === 'back') await takeOneBack(on)
    else if (kind === 'choose') await choose(on, cable, own)
    else if (kind === 'backUp') putBack = await backUp(pupil)
    else if (kind === 'restore') await putBack()
    else await cable.deliverLate()
  }
}
