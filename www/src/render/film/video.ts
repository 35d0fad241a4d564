import {
  BufferTarget,
  CanvasSource,
  getFirstEncodableVideoCodec,
  Mp4OutputFormat,
  Output,
  QUALITY_HIGH,
  WebMOutputFormat,
} from 'mediabunny'
import type { Encoder, FilmContext } from './encoder'

/** A WebM or MP4, by the browser's own encoders. */
export class Video implements Encoder {
  private pictures = 0

  private constructor(
    private readonly output: Output,
    private readonly target: BufferTarget,
    private readonly source: CanvasSource,
    private readonly rate: number,
    private readonly type: string,
  ) {}

  static async begin(format: 'webm' | 'mp4', { canvas }: FilmContext, rate: number): Promise<Video> {
    const { width, height } = canvas
    const kind = format === 'webm' ? new WebMOutputFormat() : new Mp4OutputFormat()
    const codec = await getFirstEncodableVideoCodec(kind.getSupportedVideoCodecs(), { width, height })
    if (!codec) throw new Error(`this browser cannot write ${format}`)
    const target = new BufferTarget()
    const output = new Output({ format: kind, target })
    const source = new CanvasSource(canvas, { codec, bitrate: QUALITY_HIGH })
    output.addVideoTrack(source, { frameRate: rate })
    await output.start()
    return new Video(output, target, source, rate, kind.mimeType)
  }

  async add(): Promise<void> {
    await this.source.add(this.pictures / this.rate, 1 / this.rate)
    this.pictures += 1
  }

  async end(): Promise<Blob> {
    await this.output.finalize()
    return new Blob([this.target.buffer ?? new ArrayBuffer(0)], { type: this.type })
  }

  cancel(): Promise<void> {
    return this.output.cancel()
  }
}
