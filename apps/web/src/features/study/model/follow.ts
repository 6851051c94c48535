import { houseIdOf } from '#content/cards.ts'
import { recorded, type RecordedLab } from '@botgarten/experiments/study'
import type { Lab } from '@botgarten/lab'
import type { LabEvent } from '#lab/change.ts'
import type { LabSession } from '#lab/session.svelte.ts'
import { device } from './device.svelte.ts'

/** With which the lab of a page is loaded. */
const seed = 1

/** Writes down what is done in a lab, while its child wants that. Returns how to end it. */
export function follow(session: LabSession): () => void {
  const place = houseIdOf(session.opened.card) ?? 'free'
  let plain: Lab | null = null
  let held: RecordedLab | null = null
  const begin = () => {
    const { pen } = device
    if (!pen || held) return
    session.lab.tap((lab) => {
      plain = lab
      held = recorded(lab, pen, { place, seed })
      return held.lab
    })
  }
  const end = () => {
    held?.end()
    if (plain) session.lab.tap(() => plain!)
    plain = held = null
  }
  const sync = () => (device.writes ? begin() : end())
  const leave = [
    device.beforeEnd(end),
    device.listen(sync),
    session.listen(hears(session.progress.hints)),
    heard('pagehide', () => (held?.flush(), device.leave())),
    heard('storage', device.look),
  ]
  device.hold()
  sync()
  return () => {
    for (const one of leave) one()
    end()
    device.keep()
  }
}

/** Hints, and learning by trying: what no verb of the lab says. */
function hears(hints: number): (event: LabEvent) => void {
  let shown = hints
  return (event) => {
    if (event.kind !== 'changed') return
    const { change } = event
    if (change.kind === 'progress' && change.after.hints > shown) {
      shown = change.after.hints
      device.write({ event: 'hint', shown })
    }
    if (change.kind !== 'learned') return
    const { seed, moves } = change.after
    device.write({ event: 'learned', seed, moves })
  }
}

function heard<Name extends keyof WindowEventMap>(
  event: Name,
  act: (event: WindowEventMap[Name]) => void,
): () => void {
  addEventListener(event, act)
  return () => removeEventListener(event, act)
}
