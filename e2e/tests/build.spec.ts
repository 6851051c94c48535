// Rooms: world
import type { Project } from '@botgarten/programs'
import { Builder } from '../child-build.ts'
import type { Child } from '../child.ts'
import { expect, test } from '../house.ts'
import { grey, picture } from '../png.ts'
import { freeProgram } from '../projects.ts'
import { languagesOf } from '../words.ts'

async function builds(child: Child, place = 'free'): Promise<Builder> {
  await child.opensLab(place)
  const builder = new Builder(child)
  await builder.begins()
  return builder
}

const square = {
  x: 0.4,
  y: 0.4,
  w: 0.1,
  h: 0.15,
  theta: 0,
  color: '#33B8CA',
  form: 'RECTANGLE',
  type: 'OBSTACLE',
}
const foreignScene = (obstacles: number) => ({
  robotPoses: [[{ x: 0.2, y: 0.3, theta: 0 }, { x: 0.2, y: 0.3, theta: 0 }]], // prettier-ignore
  obstacles: Array.from({ length: obstacles }, () => square),
  colorAreas: [{ x: 0.7, y: 0.7, r: 30 / 750 / 480, color: '#FBED00', form: 'CIRCLE', type: 'COLORAREA' }],
  marker: [],
})
const json = (data: unknown) => Buffer.from(JSON.stringify(data))

const file = async (child: Child) => JSON.parse(await child.savesFile()) as { assets: object; world: { size: object; floor: { asset?: string }; areas: object[]; lines: object[]; obstacles: { shape: object; fixed: boolean; colour: string }[] } } // prettier-ignore

for (const language of languagesOf(import.meta.filename)) {
  test.describe(`a child that reads ${language}`, () => {
    test.use({ language })

    test('puts a thing down, pulls it bigger, paints it, lets Bo push it, copies it and takes it away; undo takes all back', async ({
      child,
    }) => {
      const builder = await builds(child)
      const before = await builder.things.count()
      await builder.addsThing('circle')
      const ball = builder.all('world.thing.circle')
      await expect(ball).toHaveCount(1)

      const handle = child.button('build.size', { thing: child.word('world.thing.circle') })
      const grip = await child.middleOf(handle)
      await child.drags(grip, { x: grip.x + 30, y: grip.y + 30 })
      await builder.chooses('red')
      await builder.tool('build.movable').click()
      await expect(builder.tool('build.movable')).toHaveAttribute('aria-pressed', 'true')
      await builder.tool('build.copy').click()
      await expect(ball).toHaveCount(2)
      const thing = (await file(child)).world.obstacles.at(-1)!
      expect(thing).toMatchObject({ fixed: false, colour: '#B30006', shape: { kind: 'circle' } })
      expect((thing.shape as { radius: number }).radius).toBeGreaterThan(18)

      await builder.tool('build.remove').click()
      await expect(ball).toHaveCount(1)
      for (let step = 0; step < 6; step += 1) await child.presses('lab.undo')
      await expect(builder.things).toHaveCount(before)
      await expect(child.button('lab.undo')).toHaveAttribute('aria-disabled', 'true')
      for (let step = 0; step < 6; step += 1) await child.presses('lab.redo')
      await expect(ball).toHaveCount(1)
    })

    test('draws a wall, a line by hand and a line from point to point, and finds all again after a reload', async ({
      child,
    }) => {
      const builder = await builds(child)
      await builder.tool('build.addWall').click()
      await child.drags(await builder.spot(0.3, 0.4), await builder.spot(0.7, 0.4))
      await expect(builder.all('world.thing.wall')).toHaveCount(1)
      await builder.tool('build.addLine').click()
      await child.drags(await builder.spot(0.3, 0.7), await builder.spot(0.6, 0.9))
      await expect(builder.all('build.line')).toHaveCount(1)
      for (const [right, down] of [
        [0.3, 0.5],
        [0.5, 0.6],
        [0.7, 0.5],
        [0.7, 0.5],
      ] as const) {
        // prettier-ignore
        const { x, y } = await builder.spot(right, down)
        await child.page.mouse.click(x, y)
      }
      await expect(builder.all('build.line')).toHaveCount(2)
      await builder.addsField('triangle')
      await expect(builder.all('build.area')).toHaveCount(1)
      await child.seesSaved()
      await child.reloads()
      const { world } = await file(child)
      expect([world.lines.length, world.areas.length]).toEqual([2, 1])
      expect((world.lines[1] as { points: object[] }).points).toHaveLength(3)
    })

    test('lays an own picture on the floor, also by dropping it, and Bo sees it', async ({ child }) => {
      const builder = await builds(child)
      await builder.choosesFile('build.ownPicture', 'map.png', picture(2000, 900), 'image/png')
      await expect.poll(() => child.painted.floorColour()).toBe(grey)
      await child.seesSaved()
      await child.reloads()
      await expect.poll(() => child.painted.floorColour()).toBe(grey)
      const { assets, world } = await file(child)
      expect(Object.keys(assets)).toEqual([world.floor.asset])

      const bytes = [...picture(300, 200)]
      await builder.world.evaluate((target, numbers) => {
        const data = new DataTransfer()
        data.items.add(new File([new Uint8Array(numbers)], 'other.png', { type: 'image/png' }))
        target.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }))
      }, bytes)
      await expect.poll(async () => (await file(child)).world.floor.asset).not.toBe(world.floor.asset)
    })

    test('is told what is wrong with a picture, and nothing changes', async ({ child }) => {
      const builder = await builds(child)
      const before = (await file(child)).world
      // Every other reason: picture.test.ts and picture-file.test.ts.
      const picks = 'build.ownPicture'
      await builder.choosesFile(picks, 'diary.png', Buffer.from('Dear diary, today Bo drove'))
      await builder.seesRefusal('pictureKind')
      await builder.choosesFile(
        picks,
        'odd.png',
        Buffer.concat([picture(8, 8).subarray(0, 45), picture(9, 9).subarray(60)]),
      )
      await builder.seesRefusal('pictureBroken')
      expect((await file(child)).world).toEqual(before)
    })

    test('is told what is wrong with a scene, and nothing changes', async ({ child }) => {
      const builder = await builds(child)
      const before = (await file(child)).world
      // Every other reason: scene.test.ts.
      const odd = { ...foreignScene(1), obstacles: [{ ...square, x: 'left' }] }
      await builder.choosesFile('build.openScene', 'odd.json', json(odd))
      await builder.seesRefusal('notAScene')
      expect((await file(child)).world).toEqual(before)
      await expect(child.button('lab.undo')).toHaveAttribute('aria-disabled', 'true')
    })

    test('opens a scene of Open Roberta, saves it as one of ours and opens that again', async ({ child }) => {
      const builder = await builds(child)
      await builder.choosesFile('build.openScene', 'theirs.json', json(foreignScene(3)))
      await expect(builder.all('world.thing.rectangle')).toHaveCount(3)
      const saved = await builder.savesScene()
      await child.presses('lab.undo')
      await expect(builder.all('world.thing.rectangle')).toHaveCount(0)
      await builder.choosesFile('build.openScene', 'ours.json', Buffer.from(saved))
      await expect(builder.all('world.thing.rectangle')).toHaveCount(3)
      expect((await file(child)).world.size).toEqual({ width: 243.3, height: 153.3 })
    })

    test('chooses another world by its picture; that can be taken back', async ({ child }) => {
      const builder = await builds(child)
      const before = (await file(child)).world
      await builder.opensWorldDialog()
      await child.page.getByRole('button', { name: child.word('worldName.maze') }).click()
      await expect(builder.all('world.thing.wall').first()).toBeVisible()
      await child.presses('lab.undo')
      await expect.poll(async () => (await file(child)).world).toEqual(before)
    })

    test('builds with the keyboard alone', async ({ child }) => {
      await child.opensLab('free')
      const builder = new Builder(child)
      await child.tabsAndPresses('world.build')
      await child.tabsAndPresses('build.addArea', { shape: child.word('build.rectangle') })
      const area = builder.all('build.area')
      await child.tabsTo(area)
      const { x, y } = await builder.placeOf(area)
      await child.types('Shift+ArrowRight', 'ArrowUp')
      await expect.poll(() => builder.placeOf(area)).toEqual({ x: x + 10, y: y + 1 })
      await child.tabsTo(child.button('build.size', { thing: child.word('build.area') }))
      await child.types('Shift+ArrowRight')
      await child.tabsAndPresses('build.numbers')
      await expect(builder.field('build.width').last()).toHaveValue('60')
      await child.tabsTo(builder.field('build.height').last())
      await child.types('Control+a', ...(language === 'de' ? '12,5' : '12.5'), 'Enter')
      await child.tabsTo(area)
      await child.types('Delete')
      await expect(area).toHaveCount(0)
      await child.types('Control+z', 'Control+z')
      await expect(area).toHaveCount(1)
      await child.tabsAndPresses('build.addWall')
      await expect(builder.all('world.thing.wall')).toHaveCount(1)
      await child.tabsAndPresses('build.addLine')
      await expect(builder.all('build.line')).toHaveCount(1)
    })
  })
}

test('what is built while Bo drives is there at once: Bo waits, and goes on in the new world', async ({
  child,
}) => {
  await child.opensLab('free')
  await child.pressesStart()
  await child.seesDriving()
  const builder = new Builder(child)
  await builder.begins()
  await child.seesStanding()
  await builder.addsThing('rectangle')
  await expect(builder.all('world.thing.rectangle')).toHaveCount(1)
  await child.presses('lab.continue')
  await child.seesDriving()
  await builder.addsThing('circle')
  await expect(builder.all('world.thing.circle')).toHaveCount(1)
  await child.seesDriving()
})

test('taking back a change of a thing that Bo has pushed leaves it where it was pushed to', async ({
  child,
}) => {
  const project = JSON.parse(freeProgram('Push', (make) => [make.drive(60, 70)])) as Project
  const shape = { kind: 'rectangle', width: 24, height: 24 } as const
  // Ahead of where the garden's Bo starts.
  const pose = { x: 149, y: 200, heading: 15 }
  const box = { id: 'box', shape, pose, fixed: false, colour: '#F7D117' }
  await child.opensLab('free')
  const pushing = { ...project, world: { ...project.world, obstacles: [box] } }
  await child.opensProject('Push', JSON.stringify(pushing))
  const builder = new Builder(child)
  await builder.begins()
  const thing = builder.all('world.thing.rectangle')
  const started = await builder.placeOf(thing)
  await child.pressesStart()
  await expect(child.button('lab.start').first()).toBeVisible({ timeout: 60_000 })
  const pushed = await builder.restsAt(thing)
  expect(pushed.x).toBeGreaterThan(started.x + 15)
  // Bo stands so near that a finger would take Bo.
  await thing.focus()
  await child.types('Enter')

  const stays = () => expect.poll(() => builder.placeOf(thing)).toEqual(pushed)
  await builder.chooses('red')
  await stays()
  await child.presses('lab.undo')
  await stays()
  await builder.types('build.x', '400')
  await expect.poll(async () => (await builder.placeOf(thing)).x).toBe(400)
  await child.presses('lab.undo')
  await stays()
  await builder.tool('build.remove').click()
  await expect(thing).toHaveCount(0)
  await child.presses('lab.undo')
  await stays()
  // A run that begins again still begins where it began.
  await child.presses('lab.resetWorld')
  await expect.poll(() => builder.placeOf(thing)).toEqual(started)
})

test("on a card a child may build too; the card's checks stay", async ({ child }) => {
  const builder = await builds(child, 'friendship')
  await builder.addsThing('triangle')
  await expect(builder.all('world.thing.triangle')).toHaveCount(1)
  await builder.ends()
  await child.seesCheck('friendship', 'near', false)
  await builder.begins()
  await builder.opensWorldDialog()
  await expect(child.words('build.newWorld'), 'the card keeps its world').toHaveCount(0)
})

test('a world of another size keeps everybody on its floor; an odd size is not taken', async ({ child }) => {
  const builder = await builds(child)
  await builder.opensWorldDialog()
  const width = builder.field('build.width')
  await width.fill('abc')
  await child.page.keyboard.press('Enter')
  await expect(width).toHaveAttribute('aria-invalid', 'true')
  await width.fill('150')
  await child.page.keyboard.press('Enter')
  await child.page.keyboard.press('Escape')
  for (const thing of await builder.things.all()) {
    const label = (await thing.getAttribute('aria-label'))!
    if (/\d/.test(label))
      await expect.poll(async () => (await builder.placeOf(thing)).x).toBeLessThanOrEqual(150)
  }
  expect((await file(child)).world.size).toEqual({ width: 150, height: 400 })
})

test('things inside each other and in Bo come to stand side by side, and the file says where', async ({
  child,
}) => {
  const project = JSON.parse(freeProgram('Heap', (make) => [make.wait(1)])) as Project
  const { pose } = project.world.robots[0]!
  const shape = { kind: 'rectangle', width: 24, height: 24 } as const
  const heap = Array.from({ length: 6 }, (_, i) => ({
    ...{ id: `box${i}`, shape, pose, fixed: false, colour: '#F7D117' },
  }))
  await child.opensProjectAtHome(
    'Heap',
    JSON.stringify({ ...project, world: { ...project.world, obstacles: heap } }),
  )
  const kept = JSON.parse(await child.savesFile()) as Project
  expect(kept.world.robots[0]!.pose).toEqual(pose)
  const builder = new Builder(child)
  await builder.begins()
  const boxes = builder.all('world.thing.rectangle')
  await expect(boxes).toHaveCount(6)
  const places = [pose, ...(await Promise.all((await boxes.all()).map((box) => builder.placeOf(box))))]
  for (const [i, one] of places.entries())
    for (const other of places.slice(i + 1))
      expect(Math.hypot(one.x - other.x, one.y - other.y)).toBeGreaterThan(18)
})

test('a full world says so', async ({ child }) => {
  const builder = await builds(child)
  await builder.choosesFile('build.openScene', 'full.json', json(foreignScene(100)))
  await expect(builder.all('world.thing.rectangle')).toHaveCount(100)
  await builder.addsThing('circle')
  await expect(child.words('build.full', { most: 100 })).toBeVisible()
  await expect(builder.all('world.thing.circle')).toHaveCount(0)
  await child.pressesStart()
  await child.watches(20)
})

test('the floor comes nearer by buttons, wheel and keys, and all of it is to be seen again', async ({
  child,
  page,
}) => {
  await child.opensLab('free')
  const { world } = new Builder(child)
  const width = () => child.painted.wheelsApart()
  await child.presses('world.all')
  const whole = await width()
  await child.presses('world.nearer')
  await expect.poll(width).toBeGreaterThan(whole * 1.2)
  const near = await width()
  const { x, y } = await child.middleOf(world)
  await page.mouse.move(x, y)
  await page.mouse.wheel(0, -200)
  await expect.poll(width).toBeGreaterThan(near)
  await world.focus()
  await child.types('-', '-', '0')
  await expect.poll(width).toBeCloseTo(whole, 0)
})

test('a robot that is stuck can be brought back to its start', async ({ child }) => {
  await child.opensLab('free')
  // Behind the garden's start stands the fence.
  await child.opensProject(
    'Far',
    freeProgram('Far', (make) => [make.drive(60, -2000)]),
  )
  const start = await child.boStands()
  await child.pressesStart()
  await expect(child.words('world.lost')).toBeVisible({ timeout: 90_000 })
  await child.presses('lab.pause')
  await child.presses('world.bringBack')
  await expect(child.words('world.lost')).toBeHidden()
  await expect.poll(() => child.boStands()).toBe(start)
})
