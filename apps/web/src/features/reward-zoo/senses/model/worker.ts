// Learns and drives beside the page: eight minutes of trying take seconds, in which nothing on the screen may wait.
import { mending, watchedIn, type Mended, type Place, type SenseCage } from '@botgarten/experiments/cages'
import { paintFloor } from '@botgarten/simulation'
import type { Grounds, Order, Report } from './messages.ts'

let cage: SenseCage
let place: Place
const post = (report: Report) => self.postMessage(report)

/** Where nothing looks at the floor a plain one does. */
function placeOf({ worlds, picture }: Grounds): Place {
  const world = worlds[0]!
  const floor = picture ? paintFloor(world, picture) : paintFloor({ ...world, floor: { colour: '#FFFFFF' } })
  return { worlds, floor }
}

function learned({ pay, seed }: Extract<Order, { kind: 'learn' }>): Mended {
  const tries = mending(cage, place, pay, seed)
  for (;;) {
    const { done, value } = tries.next()
    if (done) return value
    post({ kind: 'minute', minute: value })
  }
}

self.onmessage = ({ data: order }: MessageEvent<Order>) => {
  if (order.kind === 'open') {
    cage = order.cage
    place = placeOf(order.grounds)
    return
  }
  const mended = order.kind === 'learn' ? learned(order) : { table: order.table, minute: null }
  post({ kind: 'seen', seen: { ...mended, ...watchedIn(cage, place, mended.table) } })
}
