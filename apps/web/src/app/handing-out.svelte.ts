import type { Project } from '@botgarten/programs'
import { gallery } from '#features/gallery/feature.ts'
import { openRoberta, type Outgoing } from '#features/open-roberta/feature.ts'
import { share } from '#features/share/feature.ts'
import { loadPart } from '#parts/feature.ts'

type Loaded<Part extends { readonly load: () => unknown }> = Awaited<ReturnType<Part['load']>>

/** What is asked before a project goes to somebody else. The dialogs come with the first question. */
type Asking =
  | { readonly kind: 'link'; readonly Dialog: Loaded<typeof share>['default']; readonly project: Project }
  | {
      readonly kind: 'class'
      readonly Dialog: Loaded<typeof gallery>['ShareInClass']
      readonly project: Project
    }
  | {
      readonly kind: 'open-roberta'
      readonly Dialog: Loaded<typeof openRoberta>['SaveDialog']
      readonly outgoing: Outgoing
    }

export class HandingOut {
  #asking = $state.raw<Asking | null>(null)

  get asking() {
    return this.#asking
  }

  close = (): void => {
    this.#asking = null
  }

  async share(project: Project): Promise<void> {
    const { default: Dialog } = await loadPart(share)
    this.#asking = { kind: 'link', Dialog, project }
  }

  /** With the class of the pupil whose device this is. */
  async shareInClass(project: Project): Promise<void> {
    const { ShareInClass: Dialog } = await loadPart(gallery)
    this.#asking = { kind: 'class', Dialog, project }
  }

  /** As a file: at once where Open Roberta knows all of it. `robot`: the first where none is named. */
  async saveForOpenRoberta(project: Project, robot?: string): Promise<void> {
    const { saveOpenRobertaFile, SaveDialog: Dialog } = await loadPart(openRoberta)
    const outgoing = saveOpenRobertaFile(project, robot)
    this.#asking = outgoing && { kind: 'open-roberta', Dialog, outgoing }
  }
}
