import { content } from '@botgarten/content/files'
import { SenseVisitor } from '../child-sense-zoo.ts'
import { ZooVisitor } from '../child-zoo.ts'
import { expect, test } from './gate.ts'

test.use({ language: 'de' })

const fountain = content.cages.find(({ cage }) => cage.id === 'fountain')!
const spinner = content.senseCages.find(({ cage }) => cage.id === 'spinner')!

test(
  'a cheat is guessed and seen; less pay that is still too much does not fix it, the right pay does',
  {
    tag: ['@reward-zoo', '@/zoo'],
  },
  async ({ child, page }) => {
    const zoo = new ZooVisitor(child)
    const text = fountain.text['de']!
    await zoo.comes()
    await zoo.enters(fountain)
    await expect(page.getByText(text.does.never)).toHaveCount(0)
    await zoo.guesses(fountain)
    await zoo.watches(fountain, 'never')
    await zoo.steps()
    const slider = page.getByRole('slider', { name: text.mend })
    // A reward of 18 still pays for staying, 17 does not.
    await slider.focus()
    await child.types('ArrowLeft', 'ArrowLeft')
    await expect(slider).toHaveValue('18')
    await expect(child.words('zoo.mended')).toHaveCount(0)
    await child.types('ArrowLeft')
    await zoo.seesMended(fountain)
    await zoo.watches(fountain, 'wish')
    await zoo.leaves(1)
  },
)

test(
  'with its own sensors Bo cheats too, and drives as is meant once the pay is fixed',
  {
    tag: ['@reward-zoo', '@/zoo'],
  },
  async ({ child }) => {
    const zoo = new SenseVisitor(child)
    await zoo.comes()
    await zoo.enters(spinner)
    await expect(child.button('zoo.senses.add')).toHaveCount(0)
    await zoo.guesses(spinner)
    await zoo.watches(spinner)
    await zoo.mends(spinner)
    await zoo.triesUntilMended()
    await zoo.leaves()
    await expect(child.words('zoo.mended')).toBeVisible()
  },
)
