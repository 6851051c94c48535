import { isView, questionnaires } from '#features/questionnaires/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

/** Without `?form=` the page shows all forms; `show` says what of a form. */
export const load: PageLoad = async ({ url }) => {
  await fetchWords(...questionnaires.words)
  const show = url.searchParams.get('show')
  return {
    form: url.searchParams.get('form'),
    show: isView(show) ? show : null,
    young: url.searchParams.get('for') === 'young',
  }
}
