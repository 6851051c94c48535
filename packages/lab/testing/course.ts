import type { Program } from '@botgarten/programs'
import type { DriveKey, Lab } from '../index.ts'
import { labWith, worldWith } from './scene.ts'

/** What happens in a run, one after the other. */
export type Act =
  | { readonly act: 'advance'; readonly ticks: number }
  | { readonly act: 'block' }
  | { readonly act: 'weight'; readonly weight: number }
  | { readonly act: 'place'; readonly id: string; readonly x: number; readonly y: number }
  | { readonly act: 'key'; readonly key: DriveKey; readonly down: boolean }

/** An act that has been done, and the ticks at which it began and ended. */
interface Done {
  readonly act: Act
  readonly from: number
  readonly to: number
}

export type Course = readonly Done[]

export function begin(main: Program, robots: number): Lab {
  const lab = labWith(main, worldWith(robots))
  lab.start()
  return lab
}

/** Does an act in the present. */
export function execute(lab: Lab, act: Act): Done {
  const from = lab.view().tick
  if (act.act === 'advance') {
    lab.resume()
    lab.advance(act.ticks)
    lab.pause()
  } else if (act.act === 'block') lab.step('block')
  else if (act.act === 'weight') lab.setWeight('net', 'eyeLeft', 'wheelRight', act.weight)
  else if (act.act === 'place') lab.place(act.id, { x: act.x, y: act.y, heading: 0 })
  else lab.press(act.key, act.down)
  return { act, from, to: lab.view().tick }
}

/** What has been done before a tick; what would go beyond it goes up to it. */
export const until = (course: Course, tick: number): Course =>
  course.flatMap((done) => {
    if (done.from >= tick) return []
    if (done.to <= tick) return [done]
    return [{ ...done, act: { act: 'advance', ticks: tick - done.from }, to: tick }]
  })

/** A lab that has done nothing but this, and never went back. */
export function afresh(main: Program, robots: number, course: Course): Lab {
  const lab = begin(main, robots)
  for (const { act } of course) execute(lab, act)
  return lab
}
