import { trailOf, nowhere, reportOf, type AtWork } from './report.ts'
import { describe, expect, test } from 'vitest'

const check = (id: string, passed: boolean) => ({ id, passed, at: null })
const robot = (points: number) => ({
  pose: { x: 100.4, y: 50.6, heading: 725 },
  trail: Array.from({ length: points }, (_, at) => ({ t: at / 10, x: at + 0.4, y: 200, heading: 0 })),
})
const work = (changes: Partial<AtWork> = {}, points = 3): AtWork => ({
  ...{ card: 'friendship', project: 'friendship', checks: ['near', 'stays'], missed: null, failed: 0 },
  size: { width: 600, height: 400 },
  view: {
    phase: 'running',
    checks: [check('near', true), check('stays', false)],
    robots: [robot(points)],
  } as unknown as AtWork['view'],
  ...changes,
})

describe('what a page reports to the class', () => {
  test('names card and project as the class knows them, and how far each check is', () => {
    expect(reportOf(work())).toMatchObject({
      ...{ card: 'friendship', project: 'project-friendship', checks: ['passed', 'open'] },
      ...{ running: true, size: [600, 400], pose: { x: 100.4, y: 50.6, heading: 5 } },
    })
    expect(reportOf(work({ missed: 'stays', failed: 4 }))).toMatchObject({
      ...{ checks: ['passed', 'failed'], failed: 4 },
    })
  })

  test('holds the last part of the trail, five points a second, in less than 2 kB', () => {
    expect(trailOf(robot(5).trail)).toEqual([0, 200, 2, 200, 4, 200])
    const { trail } = reportOf(work({}, 9000))
    expect(trail).toHaveLength(320)
    expect(trail.slice(-2)).toEqual([8999, 200])
    expect(JSON.stringify(trail).length).toBeLessThan(2048)
  })

  test('says nothing of a lab where none is open', () => {
    expect(nowhere).toMatchObject({ card: null, pose: null, trail: [] })
  })
})
