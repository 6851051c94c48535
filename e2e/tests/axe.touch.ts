// Rooms: class, questionnaires, gallery, materials
// axe where a tablet shows something else than a laptop does.
import { opensForm } from '../asked-class.ts'
import { findsNothing } from '../axe.ts'
import { GalleryHands, sharesOne } from '../child-gallery.ts'
import { testInClass } from '../class-test.ts'
import { expect } from '../house.ts'
import { joins, signsIn } from '../made-class.ts'
import { opensFromHome } from '../navigation.ts'
import { pupilScreens } from '../screens-class.ts'

const test = testInClass('de')
test.use({ language: 'de' })

test('axe finds nothing where a child of grade 3 chooses its bird', ({ child, school }) =>
  findsNothing(child, {
    'a bird and a number': async ({ page }) => {
      await school.teacher.ask('PATCH', `/classes/${school.id}`, { grade: 3 })
      await opensForm(school, 'after')
      await signsIn(page, school, await joins(school, 'Kiwi'))
      await page.goto('/')
      await page.getByRole('link', { name: child.word('class.askedGo'), exact: true }).tap()
      await expect(child.words('form.codeTitle')).toBeVisible()
    },
  }))

test('axe finds nothing where something that was shared drives', ({ child, school }) =>
  findsNothing(child, {
    'it drives': async ({ page }) => {
      await sharesOne(await joins(school, 'Eule'), 'Scheuer Bo')
      await signsIn(page, school, await joins(school, 'Fuchs'))
      const gallery = new GalleryHands(child)
      await gallery.opens()
      await gallery.looks('Scheuer Bo')
      const start = await gallery.place()
      await child.button('gallery.watch').tap()
      await expect.poll(gallery.place).not.toEqual(start)
    },
  }))

test('axe finds nothing where two work on one program', ({ child, school }) =>
  findsNothing(child, {
    together: () => pupilScreens.find(({ name }) => name === 'together')!.show(child, school),
  }))

test('axe finds nothing where an item lies over the library', ({ child }) =>
  findsNothing(child, {
    'an item over the library': async ({ page }) => {
      await opensFromHome(child, 'home.materials')
      const name = child.card('city')
      await child.button('materials.look', { title: name }).tap()
      await expect(page.getByRole('dialog', { name }).locator('.material[aria-busy="false"]')).toBeVisible()
    },
  }))
