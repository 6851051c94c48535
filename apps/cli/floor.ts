import { content } from '@botgarten/content/files'
import { FloorError } from '@botgarten/simulation/png'
import { FileError } from './errors.ts'

/**
 * The floor of a world, which may be a picture of the project's own.
 * @throws {FileError} if the picture cannot be used
 */
export const floorOf: typeof content.floorOf = (world, assets) => {
  try {
    return content.floorOf(world, assets)
  } catch (error) {
    throw error instanceof FloorError ? new FileError(`file.floor.${error.problem}`) : error
  }
}
