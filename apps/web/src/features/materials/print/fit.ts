import './paper.css'
import './sheets.css'
import './answers.css'
import './cards.css'
import './by-hand.css'

/** Smaller is not read any more: what still does not fit is cut, and a test says so. */
const least = 0.5
const step = 0.02
/** A sheet that goes on for a few lines on one more page is drawn in by so much at most. */
const leastOfSheet = 0.84
/** What children read is 11 pt then, and what the youngest read stays at 12 pt. */
const leastOfPupils = 0.92
/** Room for a hand, and pictures, give way first: to so much of what they have. */
const rooms = [1, 0.92, 0.84, 0.76, 0.68, 0.6]
/** What has room to spare on its one page gives it to rows, fields and pictures: so much of what they have. */
const roomsToSpare = [1.4, 1.3, 1.2, 1.1]
/** The room on a page of A4 in px of CSS: 297 mm without its margins. */
const sheetHeight = ((297 - 16 - 20) / 25.4) * 96
const spare = 30
/** A picture leaves room for what says what it is. */
const tallest = sheetHeight - 110

/** Boxes of fixed height whose content may be made smaller: a card's middle, what stands on a side or a slide. */
const boxes = '.a-card > .body, .leaf > .box'

/** A card that would have to be made smaller than this is laid out more tightly instead. */
const leastOfCard = 0.98
/** How wide its picture may be then beside blocks, in px of CSS. */
const picturesOfTight = [300, 280, 260, 240, 220, 200, 180, 160, 140, 120]

/** Makes something smaller until it fits. How small is written to `data-zoom`. */
function shrink(element: HTMLElement, floor: number, tooTall: () => boolean): void {
  let zoom = 1
  element.style.setProperty('zoom', '1')
  while (zoom > floor && tooTall()) element.style.setProperty('zoom', (zoom -= step).toFixed(2))
  element.dataset['zoom'] = zoom.toFixed(2)
}

/** Where that is not enough, what is left out, one after the other (cards.css). */
const fullness = ['full', 'fuller']

/** Gives hands and pictures less room until it fits. @returns whether it does */
const makesRoom = (element: HTMLElement, tooTall: () => boolean, of: readonly number[] = rooms): boolean =>
  of.some((room) => {
    element.style.setProperty('--room', String(room))
    return !tooTall()
  })

const tooMuch = (box: HTMLElement) =>
  box.scrollHeight > box.clientHeight + 1 || box.scrollWidth > box.clientWidth + 1

const heightOf = (element: Element) => element.getBoundingClientRect().height

function fitSheet(flow: HTMLElement): void {
  for (const figure of flow.querySelectorAll<HTMLElement>('figure, img'))
    if (heightOf(figure) > tallest) shrink(figure, least, () => heightOf(figure) > tallest)
  flow.style.setProperty('zoom', '1')
  // Blocks of whole programs are as small as they may be.
  if (flow.closest('.solution')) return
  // Where pages end something is left free: what seems to fit by a line does not.
  const pages = Math.floor((heightOf(flow) + spare) / sheetHeight)
  if (pages === 0) return fill(flow)
  // What is left over must fit as well: else nothing is won.
  const tooTall = () => heightOf(flow) + spare > pages * sheetHeight
  if (makesRoom(flow, tooTall)) return
  shrink(flow, leastOf(flow), tooTall)
  if (!tooTall()) return
  shrink(flow, 1, () => false)
  flow.style.setProperty('--room', '1')
}

function fill(flow: HTMLElement): void {
  const overflows = () => heightOf(flow) + spare > sheetHeight
  if (!makesRoom(flow, overflows, roomsToSpare)) flow.style.setProperty('--room', '1')
}

const leastOf = (flow: HTMLElement) =>
  flow.closest('.youngest') ? 1 : flow.closest('.pupils') ? leastOfPupils : leastOfSheet

function fitBox(box: HTMLElement): void {
  const card = box.parentElement!
  card.classList.remove('tight', 'broad', ...fullness)
  box.style.setProperty('zoom', '1')
  const tooTall = () => tooMuch(box)
  const fits =
    makesRoom(box, tooTall) ||
    fullness.some((name) => {
      card.classList.add(name)
      return makesRoom(box, tooTall)
    })
  shrink(box, least, fits ? () => false : tooTall)
  const full = Number(box.dataset['zoom']) < leastOfCard
  if (full && box.querySelector(':scope > :is(img, .world) ~ .columns')) fitTight(card, box)
}

function fitTight(card: HTMLElement, box: HTMLElement): void {
  card.classList.add('tight')
  box.style.setProperty('--room', '1')
  card.classList.toggle('broad', box.querySelector('.columns .blocks, :scope > .world') === null)
  box.style.setProperty('zoom', '1')
  const fits = (width: number) => {
    box.style.setProperty('--picture', `${width}px`)
    return !tooMuch(box)
  }
  picturesOfTight.find(fits)
  shrink(box, least, () => tooMuch(box))
}

/** Fits all that is on a paper into its pages. */
export function fitAll(paper: HTMLElement): void {
  for (const box of paper.querySelectorAll<HTMLElement>(boxes)) fitBox(box)
  for (const flow of paper.querySelectorAll<HTMLElement>('.flow')) fitSheet(flow)
}

/** What is printed straight from its page (Ctrl+P) is laid out as paper as long as it is printed. */
export function printable(article: HTMLElement): () => void {
  const { paper = 'a4', kind = '' } = article.dataset
  const sheet = paper === 'a4' && kind !== 'plan'
  const names = ['paper', 'by-hand', ...(sheet ? ['sheet'] : paper === 'a5' ? ['cards-a5'] : []), kind]
  const flows = sheet ? [...article.querySelectorAll('.side')] : []
  const before = () => {
    article.classList.add(...names)
    for (const flow of flows) flow.classList.add('flow')
    fitAll(article)
  }
  const after = () => {
    article.classList.remove(...names)
    for (const flow of flows) flow.classList.remove('flow')
  }
  window.addEventListener('beforeprint', before)
  window.addEventListener('afterprint', after)
  return () => {
    window.removeEventListener('beforeprint', before)
    window.removeEventListener('afterprint', after)
  }
}
