// Rooms: debug, lab
import { leftEye, leftWheel, rightWheel, type Child } from '../child.ts'
import { TimeHands } from '../child-time.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

/** Bo circles for two seconds, then a knob is turned, then Bo goes on for two more. */
async function drivesTwice(child: Child): Promise<TimeHands> {
  const time = new TimeHands(child)
  await child.opensLab('friendship')
  await child.typesWeight(leftEye, leftWheel, 0.6)
  await child.typesWeight(leftEye, rightWheel, 0.25)
  await child.pressesStart()
  await time.opens()
  await time.runsUntil(2)
  await child.typesWeight(leftEye, leftWheel, 0.3)
  await child.presses('lab.continue')
  await time.runsUntil(4)
  return time
}

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`the time machine, in ${language}`, () => {
    test.use({ language })

    test('goes back by keys and by hand, shows the weights of then, and comes back to now', async ({
      child,
      page,
    }) => {
      const time = await drivesTwice(child)
      const [now, bo] = [await time.at(), await child.boStands()]
      await time.goesBack('Home')
      await expect.poll(() => time.at()).toBe(0)
      await child.seesWeight(leftEye, leftWheel, 0.6)
      await expect(page.getByText(child.word('time.then'))).toBeVisible()
      await expect.poll(() => child.boStands()).not.toBe(bo)
      await time.goesBack('Shift+ArrowRight', 'ArrowRight')
      await expect.poll(() => time.at()).toBeCloseTo(1.1, 1)
      const spoken = (1.1).toLocaleString(language, { minimumFractionDigits: 1 })
      await expect(time.slider).toHaveAttribute(
        'aria-valuetext',
        child.word('time.seconds', { seconds: spoken }),
      )

      const middle = await child.middleOf(time.slider)
      const box = (await time.slider.boundingBox())!
      await child.drags({ x: box.x + 40, y: middle.y }, { x: box.x + 90, y: middle.y })
      await expect.poll(() => time.at()).toBeLessThan(now)
      await child.presses('time.toNow')
      await expect.poll(() => time.at()).toBe(now)
      await expect.poll(() => child.boStands()).toBe(bo)
      await child.seesWeight(leftEye, leftWheel, 0.3)
    })

    test('steps show what was, the block and the network too; Stop is in the present', async ({ child }) => {
      const time = await drivesTwice(child)
      const bo = await child.boStands()
      await time.goesBack('Home', 'Shift+ArrowRight')
      await child.presses('time.back')
      await child.presses('time.back')
      await child.presses('time.forth')
      const at = await child.boStands()
      await child.steps('stepBlock')
      await child.steps('stepNetwork')
      await expect.poll(() => child.boStands()).not.toBe(at)
      await expect(child.button('time.goOn')).toBeVisible()
      await child.types('Escape')
      await expect(child.button('lab.start').first()).toBeVisible()
      await expect.poll(() => child.boStands()).toBe(bo)
    })

    test('slow and fast: the page stays alive', async ({ child }) => {
      const time = await drivesTwice(child)
      await time.chooses('0.25')
      await child.presses('lab.continue')
      await child.seesDriving()
      const slow = await time.at()
      await time.chooses('Infinity')
      await expect.poll(() => time.at()).toBeGreaterThan(slow + 60)
      await child.watches(30)
      await child.pressesStop()
      await child.seesStanding()
    })
  })
}
