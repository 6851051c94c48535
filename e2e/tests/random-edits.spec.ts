// Rooms: network, editor, q-learning, world
import { content } from '@botgarten/content/files'
import type { ElementHandle, Locator } from '@playwright/test'
import type { Child } from '../child.ts'
import { isLong } from '../beds.ts'
import { TimeHands } from '../child-time.ts'
import { noteSequence, wasPassed } from '../edits-log.ts'
import { expect, test } from '../house.ts'

const asked = process.env['BOTGARTEN_EDITS']
/**
 * Sequences, each on the next card: a sample, or 300 in `npm run test:long`. `BOTGARTEN_EDITS=<number>` runs another number, notes
 * each sequence, and leaves out those that have passed in an earlier run: a run that was ended is resumed.
 */
const sequences = asked !== undefined ? Number(asked) : isLong ? 300 : 10
/**
 * Edits of one sequence, how many of them change the project, and attempts at most: a control may be covered, off or gone by the
 * time.
 */
const [wanted, changing, attempts] = [8, 2, 90]

/** Numbers from a seed: 0 to below `count`. */
function pickerOf(seed: number) {
  let state = seed
  return (count: number) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0
    return Math.floor((state / 2 ** 32) * count)
  }
}

/** Buttons, tabs, switches and knobs of the lab that can be used now. */
const controls = [
  'button',
  '[role=tab]',
  '[role=slider]',
  'input[type=checkbox]',
  'input[type=radio]',
  'select',
]
const usable = `main :is(${controls.join(', ')}):not(:disabled, [aria-disabled=true])`
const sliders = 'main [role=slider]:not([aria-disabled=true])'

/** Deletes a block, copies it, or undoes the last step. @returns the edit in words; null if none happened */
async function editsBlock(child: Child, below: (count: number) => number): Promise<string | null> {
  const { page } = child
  // On a map the program is folded.
  const unfold = child.button('lab.unfold').first()
  if (await unfold.isVisible()) await unfold.press('Enter', { timeout: 1_000 }).catch(() => {})
  const all = page.locator('.blocklySvg .blocklyBlockCanvas .blocklyDraggable > .blocklyPath')
  // A corner that neither another block nor the edge of the pane covers.
  const corner = 10
  const free = await all.evaluateAll(
    (paths, corner) =>
      paths.flatMap((path, index) => {
        const { x, y } = path.getBoundingClientRect()
        return document.elementFromPoint(x + corner, y + corner) === path ? [index] : []
      }),
    corner,
  )
  // Another pane fills the screen, or all blocks are deleted.
  if (free.length === 0) {
    const whole = child.button('lab.shrink')
    const other = (await whole.isVisible()) ? whole : child.button('lab.undo')
    return usesOne(child, below, other.and(page.locator(usable)))
  }
  const clicked = await all
    .nth(free[below(free.length)]!)
    .click({ timeout: 1_000, position: { x: corner, y: corner } })
    .then(
      () => true,
      () => false,
    )
  if (!clicked) return null
  const keys = [['Delete'], ['Control+c', 'Control+v'], ['Control+z']][below(3)]!
  for (const key of keys) await page.keyboard.press(key)
  return `${keys.join()} at a block`
}

/** Edits a block, turns a knob, or uses any control of the lab. @returns the edit in words; null if none happened */
async function editsOne(child: Child, below: (count: number) => number): Promise<string | null> {
  const how = below(3)
  return how === 0
    ? editsBlock(child, below)
    : usesOne(child, below, child.page.locator(how === 1 ? sliders : usable))
}

/** Uses one of these controls. @returns the edit in words; null if none happened */
async function usesOne(
  child: Child,
  below: (count: number) => number,
  which: Locator,
): Promise<string | null> {
  const all = which.filter({ visible: true })
  const count = await all.count()
  if (count === 0) return null
  // The element itself: a moment later another control may have its number.
  const one = await all
    .nth(below(count))
    .elementHandle({ timeout: 1_000 })
    .catch(() => null)
  if (!one) return null
  return useOf(child, one, below).catch(async (error: unknown) => {
    // A run may remove the control between two of these steps.
    const isThere = await one.evaluate((element) => element.isConnected).catch(() => false)
    if (isThere) throw error
    return null
  })
}

/** Turns a knob, chooses an option or clicks. @returns the edit in words; null if none happened */
async function useOf(
  { page }: Child,
  one: ElementHandle<Element>,
  below: (count: number) => number,
): Promise<string | null> {
  const [role, name] = await one.evaluate((element) => [
    element.getAttribute('role') ?? element.localName,
    (element.ariaLabel ?? element.textContent).trim(),
  ])
  if (role === 'slider') {
    const value = () => one.getAttribute('aria-valuetext')
    const before = await value()
    await one.focus()
    await page.keyboard.press(['ArrowUp', 'ArrowDown', 'Home', 'End'][below(4)]!)
    const after = await value()
    return after === before ? null : `${name}: ${after}`
  }
  if (role === 'select') {
    const value = () => one.evaluate((select) => (select as HTMLSelectElement).value)
    const before = await value()
    await one.selectOption({ index: below(2) })
    const after = await value()
    return after === before ? null : `${name}: ${after}`
  }
  return one.click({ timeout: 1_000 }).then(
    () => `${role}: ${name}`,
    () => null,
  )
}

/** Programs, weights and world of the project, as the device has them. */
const savedIn = (child: Child) =>
  child.page.evaluate(
    () =>
      new Promise<unknown>((done, fail) => {
        const opening = indexedDB.open('botgarten')
        opening.onerror = () => fail(opening.error!)
        opening.onsuccess = () => {
          const reading = opening.result.transaction('projects').objectStore('projects').getAll()
          reading.onsuccess = () => {
            opening.result.close()
            const all = reading.result as {
              project: { programs: unknown; brains: unknown; world: unknown }
            }[]
            done(all.map(({ project: { programs, brains, world } }) => ({ programs, brains, world })))
          }
        }
      }),
  )

/** Shown values by their names. */
type Facts = { readonly [fact: string]: string }

/**
 * The lab as the page shows and paints it: name, blocks, knobs and other values, networks, robots and things.
 * @returns blocks: null if the page has no editor, since another pane fills the screen
 */
async function shownIn(child: Child, withWorld = true) {
  const { page } = child
  // The mouth for variables comes with the blocks of the large toolbox, which a reload loads only where a program needs them.
  const late = ['more.variables', 'more.parameters'].map((key) => child.word(key))
  // The programs of other robots stay open behind that of the chosen one; a reload opens only the latter.
  const blocks = await page.locator('.program:not([hidden]) .blocklySvg .blocklyBlockCanvas').evaluateAll(
    ([canvas], late) =>
      canvas === undefined
        ? null
        : [...canvas.querySelectorAll('.blocklyDraggable')]
            .map((one) => {
              // Only its own words: those of the blocks in it may come in another order.
              const own = [...one.querySelectorAll('text')].filter(
                (text) => text.closest('.blocklyDraggable') === one,
              )
              const above = one.parentElement?.closest('.blocklyDraggable')?.getAttribute('data-id') ?? ''
              const words = own.map((text) => text.textContent.replaceAll(/\s+/g, ' ')).toSorted()
              const shown = words.filter((word) => !late.includes(word))
              return `${one.getAttribute('data-id')} in ${above}: ${shown.join(', ')}`
            })
            .toSorted(),
    late,
  )
  const values = await page.evaluate((): Facts => {
    const sliders = [...document.querySelectorAll('main [role=slider][aria-valuetext]')].map((one) => [
      one.ariaLabel,
      one.ariaValueText,
    ])
    const heading = document.querySelector('h1')!
    // The name may be in a field.
    const name = heading.querySelector('input')?.value ?? heading.textContent.trim()
    return Object.fromEntries([['h1', name], ...sliders]) as Facts
  })
  const lab = await page.evaluate(() => {
    const { robots, obstacles, brains } = globalThis.botgarten!.view()!
    const rounded = ({ pose: { x, y, heading } }: { pose: { x: number; y: number; heading: number } }) =>
      // A heading of 359.999 degrees is one of 0.
      [x, y, (Number(heading.toFixed(2)) + 360) % 360].map((part) => part.toFixed(2)).join()
    return {
      networks: brains,
      robots: robots.map(({ id }) => id),
      things: obstacles.map(({ id }) => id),
      poses: [...robots, ...obstacles].map((one) => `${one.id}: ${rounded(one)}`),
    }
  })
  return { blocks, values, world: withWorld ? await worldIn(child) : {}, ...lab }
}

/** The parts of the project that an edit changes. */
async function projectIn(child: Child) {
  const { blocks, networks, robots, things } = await shownIn(child, false)
  return { blocks, networks, robots, things }
}
type ProjectParts = Awaited<ReturnType<typeof projectIn>>

/** Blocks are compared where both have an editor. */
function differ(one: ProjectParts, other: ProjectParts): boolean {
  const ofBoth = one.blocks && other.blocks ? {} : { blocks: null }
  return JSON.stringify({ ...one, ...ofBoth }) !== JSON.stringify({ ...other, ...ofBoth })
}

/**
 * The painted world, seen as a whole, as coarse colours by the size of its picture: the pane may have another size after a reload.
 * Empty if the world is not on the screen.
 */
async function worldIn(child: Child): Promise<Facts> {
  const all = child.button('world.all').first()
  if (!(await all.isVisible())) return {}
  if ((await all.getAttribute('aria-disabled')) !== 'true') await all.click()
  return all.evaluate(async (button) => {
    for (let frames = 0; frames < 3; frames++) await new Promise((done) => requestAnimationFrame(done))
    let box = button.parentElement!
    while (!box.querySelector('canvas:not(.back)')) box = box.parentElement!
    const painted = box.querySelector<HTMLCanvasElement>('canvas:not(.back)')!
    const [width, height] = [24, 16]
    const coarse = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!
    coarse.imageSmoothingQuality = 'high'
    coarse.drawImage(painted, 0, 0, width, height)
    const colours = [...coarse.getImageData(0, 0, width, height).data].map((part) => Math.round(part / 51))
    return { [`${painted.width} x ${painted.height}`]: colours.join('') }
  })
}

/** Only facts that are shown in both: which panes are open is not part of the project. */
function sharedBy(one: Facts, other: Facts): Facts {
  return Object.fromEntries(Object.entries(one).filter(([fact]) => other[fact] !== undefined))
}

/** Paintings of equal size with at most 2 % other colours are equal: lines at an edge may be painted a little otherwise. */
function paintedIn(one: Facts, other: Facts): Facts {
  const shared = Object.entries(sharedBy(one, other))
  return Object.fromEntries(
    shared.map(([size, colours]) => {
      const others = [...colours].filter((colour, at) => colour !== other[size]![at]).length
      return [size, others <= 0.02 * colours.length ? 'equal' : colours]
    }),
  )
}

type Shown = Awaited<ReturnType<typeof shownIn>>

/** The part of the lab that a reload has to restore. @param atRest Bo was put back to its start, where a reload puts it */
const comparable = (one: Shown, other: Shown, atRest: boolean) => ({
  ...one,
  values: sharedBy(one.values, other.values),
  // Where Bo is, and the trail behind it, are not saved.
  world: atRest ? paintedIn(one.world, other.world) : {},
  poses: atRest ? one.poses : [],
})

/** The lab is open; its program may have no block any more. */
async function seesOpened(child: Child) {
  await expect(child.button('lab.start').or(child.button('lab.stop')).first()).toBeVisible()
  await child.page.waitForFunction(() => globalThis.botgarten?.view())
}

/** Closes dialogs, shows all panes, stops Bo, puts it back to its start and chooses the first robot, as a reload does. @returns false if the pane that can do so is not on the screen */
async function comesToRest(child: Child): Promise<boolean> {
  // A dialog loads on first use, so it can open after the Escape that follows an edit.
  await expect(async () => {
    await child.page.keyboard.press('Escape')
    await expect(child.page.locator('dialog[open]')).toHaveCount(0, { timeout: 500 })
  }).toPass({ timeout: 10_000 })
  const all = child.button('lab.shrink').first()
  if (await all.isVisible()) await all.click()
  const stop = child.button('lab.stop').first()
  if (await stop.isVisible()) {
    await stop.click()
    await expect(stop).toBeHidden()
  }
  const first = new TimeHands(child).chip(1)
  if (await first.isVisible()) await first.click()
  const back = child.button('lab.resetWorld').first()
  if (!(await back.isVisible())) return false
  if ((await back.getAttribute('aria-disabled')) !== 'true') await back.click()
  return true
}

/** The page shows the lab as it was before. */
const seesAgain = (child: Child, before: Shown, atRest: boolean, steps: readonly string[]) =>
  expect(async () => {
    const now = await shownIn(child)
    expect(comparable(now, before, atRest), steps.join('\n')).toEqual(comparable(before, now, atRest))
  }).toPass({ timeout: 30_000 })

/** A resumed run has only the sequences that have not passed yet. */
const left = Array.from({ length: sequences }, (_, sequence) => sequence).filter(
  (sequence) => asked === undefined || !wasPassed(sequence),
)

for (const sequence of left) {
  const { id } = content.cards[(sequence * 7) % content.cards.length]!

  test(`sequence ${sequence}: random edits while ${id} runs; the lab is the same after a reload`, async ({
    child,
  }) => {
    const begun = { sequence, card: id, edits: 0, changes: 0, tried: 0, passed: false }
    if (asked !== undefined) noteSequence(begun)
    const below = pickerOf(sequence + 1)
    await child.opensLab(id)
    const address = child.page.url()
    // On a map it is the learning that starts.
    await child.presses('lab.start')
    let [edits, changes, tried] = [0, 0, 0]
    let before = await projectIn(child)
    // For the message of a failure.
    const steps: string[] = []
    for (; (edits < wanted || changes < changing) && tried < attempts; tried++) {
      const step = await editsOne(child, below)
      if (step !== null) edits++
      await child.page.keyboard.press('Escape')
      // A link of the lab leads to another page, which may take a moment.
      let after = before
      await expect(async () => {
        if (new URL(child.page.url()).pathname !== new URL(address).pathname) await child.page.goBack()
        const isOpen = () => child.page.evaluate(() => Boolean(globalThis.botgarten?.view()))
        await expect.poll(isOpen, { timeout: 5_000 }).toBe(true)
        after = await projectIn(child)
      }).toPass({ timeout: 30_000 })
      const changed = differ(before, after)
      if (changed) changes++
      if (step !== null) steps.push(changed ? `${step} (changed the project)` : step)
      // Without an editor the next edit is compared with the blocks that were visible last.
      before = { ...after, blocks: after.blocks ?? before.blocks }
    }
    const done = { ...begun, edits, changes, tried }
    if (asked !== undefined) noteSequence(done)
    expect(edits).toBeGreaterThanOrEqual(wanted)
    expect(changes, steps.join('\n')).toBeGreaterThanOrEqual(changing)
    const atRest = await comesToRest(child)
    // The editor reports an edit some frames later.
    await child.watches(10)
    await child.seesSaved()
    const [saved, shown] = [await savedIn(child), await shownIn(child)]
    await child.page.reload()
    await seesOpened(child)
    await expect.poll(() => savedIn(child)).toEqual(saved)
    await seesAgain(child, shown, atRest, steps)
    await child.page.reload()
    await seesOpened(child)
    await seesAgain(child, shown, atRest, steps)
    if (asked !== undefined) noteSequence({ ...done, passed: true })
  })
}
