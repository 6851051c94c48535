// Steps of two devices of a pupil and of the class, in any order.
import fc from 'fast-check'
import {
  backUp,
  choose,
  takeOneBack,
  type Cable,
  type Device,
  type Fate,
  type Pupil,
  type Work,
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

/** Takes the steps one after the other. */
export async function play(
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
