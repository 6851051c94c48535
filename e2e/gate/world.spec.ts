import type { Project } from '@botgarten/programs'
import { Builder } from '../child-build.ts'
import { TimeHands } from '../child-time.ts'
import { leftEye, leftWheel, rightWheel } from '../child.ts'
import { expect, opensCard, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'things are built, painted, dragged and undone, and are still there after a reload',
  {
    tag: ['@world', '@/lab/[card]'],
  },
  async ({ child }) => {
    const builder = new Builder(child)
    await opensCard(child, 'friendship')
    await builder.begins()
    await builder.addsThing('circle')
    const ball = builder.all('world.thing.circle')
    await expect(ball).toHaveCount(1)
    const before = await builder.placeOf(ball)
    await builder.chooses('red')
    await builder.tool('build.movable').click()
    const from = await child.middleOf(ball)
    await child.drags(from, { x: from.x - 60, y: from.y + 40 })
    const after = await builder.placeOf(ball)
    expect(after.x).toBeLessThan(before.x)
    expect(after.y).toBeLessThan(before.y)
    await builder.tool('build.addWall').click()
    await child.drags(await builder.spot(0.3, 0.85), await builder.spot(0.7, 0.85))
    await expect(builder.all('world.thing.wall')).toHaveCount(1)
    await child.presses('lab.undo')
    await expect(builder.all('world.thing.wall')).toHaveCount(0)
    await builder.ends()
    await child.seesSaved()
    await child.reloads()
    const { world } = JSON.parse(await child.savesFile()) as Project
    expect(world.obstacles.at(-1)).toMatchObject({
      ...{ fixed: false, colour: '#B30006', shape: { kind: 'circle' } },
      pose: { x: expect.closeTo(after.x, -0.3), y: expect.closeTo(after.y, -0.3) },
    })
  },
)

test(
  'time goes back to what was, comes to now again, and goes on from then; a thing is moved while Bo drives',
  {
    tag: '@world',
  },
  async ({ child }) => {
    const time = new TimeHands(child)
    await opensCard(child, 'friendship')
    await child.typesWeight(leftEye, leftWheel, 0.6)
    await child.typesWeight(leftEye, rightWheel, 0.25)
    await child.pressesStart()
    await time.opens()
    await time.runsUntil(1.5)
    await child.typesWeight(leftEye, leftWheel, 0.3)
    const [now, bo] = [await time.at(), await child.boStands()]
    await time.goesBack('Home')
    await expect.poll(() => time.at()).toBe(0)
    await child.seesWeight(leftEye, leftWheel, 0.6)
    await expect.poll(() => child.boStands()).not.toBe(bo)
    await child.presses('time.toNow')
    await expect.poll(() => time.at()).toBe(now)
    await expect.poll(() => child.boStands()).toBe(bo)
    await child.seesWeight(leftEye, leftWheel, 0.3)
    await time.goesBack('Home')
    await child.presses('time.goOn')
    await child.seesDriving()
    await child.pressesStop()

    const place = async () => child.thing('block').getAttribute('aria-label')
    const before = await place()
    await child.dragsThing('block', { x: 40, y: -60 })
    await expect.poll(place).not.toBe(before)
    await child.presses('lab.resetWorld')
  },
)
