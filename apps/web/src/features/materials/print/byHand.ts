import { fitAll } from './fit.ts'
import './paper.css'

/** What is printed straight from its page (Ctrl+P) is laid out as paper as long as it is printed. */
export function printable(article: HTMLElement): () => void {
  const { paper = 'a4', kind = '' } = article.dataset
  const sheet = paper === 'a4'
  const names = ['paper', 'by-hand', sheet ? 'sheet' : 'cards-a5', kind]
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
